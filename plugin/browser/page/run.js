/** One run after another: starts, stops, goes on, and keeps the last state and result. */
export class Runs {
    /**
     * @param mesh  makes a run, as package/index.js does.
     * @param seen  {progress(p), ended(result, stopped), failed(error)}.
     */
    constructor(mesh, seen) {
        [this.mesh, this.seen] = [mesh, seen];
        this.number = 0;
        this.result = null;
        /** The options of the last run, and those that give the result. */
        this.options = this.made = null;
        this.sites = null;
        this.isRunning = false;
    }

    /** @param options  of mesh(); a newer run replaces one that has not ended. */
    async start(options) {
        const number = ++this.number;
        this.options = options;
        this.sites = options.sites instanceof Float64Array ? options.sites : null;
        this.release();
        this.isRunning = true;
        this.isStopping = false;
        const progress = (now) => {
            // A true value ends the run.
            if (number !== this.number || this.isStopping) return true;
            if (now.sites) this.sites = now.sites;
            this.seen.progress(now);
            return false;
        };
        await this.make(number, options, {progress, progressSites: true});
        // The state at which a run was stopped becomes the result.
        if (number === this.number && this.isRunning) {
            await this.make(number, {...withSites(options, this.sites), maxIterations: 0}, {});
        }
    }

    /** Makes the result of options, unless a newer run begins or this one is stopped. */
    async make(number, options, watched) {
        let result;
        try {
            result = await this.mesh({...options, ...watched});
        } catch (error) {
            if (number !== this.number) return;
            if (watched.progress && this.isStopping && this.sites) return;
            this.isRunning = false;
            this.seen.failed(error);
            return;
        }
        if (number !== this.number) {
            result.free();
            return;
        }
        this.isRunning = false;
        this.result = result;
        this.made = options;
        this.sites = result.sites;
        this.seen.ended(result, this.isStopping);
    }

    stop() {
        this.isStopping = this.isRunning;
    }

    /** Continues from the last state. */
    goOn() {
        return this.start(withSites(this.options, this.sites));
    }

    /** Given sites keep no symmetry, because the group is one of drawn sites. */
    get canGoOn() {
        return !this.isRunning && this.sites !== null && !this.options?.symmetry;
    }

    release() {
        this.result?.free();
        this.result = this.made = null;
    }
}

function withSites(options, sites) {
    const {symmetry, start, input, files, ...others} = options;
    // The file of given sites is the only one, if there is one.
    return {...others, ...(files && !input ? {files} : {}), sites};
}
