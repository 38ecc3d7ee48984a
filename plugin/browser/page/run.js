import {mesh} from './package/index.js';

/** One run after another: starts, stops, goes on, and keeps the last state and result. */
export class Runs {
    /** @param seen  {progress(p), ended(result), failed(error), stopped()}. */
    constructor(seen) {
        this.seen = seen;
        this.number = 0;
        this.result = null;
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
            if (number !== this.number || this.isStopping) return false;
            if (now.sites) this.sites = now.sites;
            this.seen.progress(now);
            return true;
        };
        try {
            const result = await mesh({...options, progress, progressSites: true});
            if (number === this.number)
                this.end(result);
            else
                result.free();
        } catch (error) {
            if (number === this.number) await this.fail(error, options);
        }
    }

    end(result) {
        this.isRunning = false;
        this.result = result;
        this.sites = result.sites;
        this.seen.ended(result, this.isStopping);
    }

    /** Makes the state at which a run was stopped the result. */
    async fail(error, options) {
        this.isRunning = false;
        if (!this.isStopping || !this.sites) {
            this.seen.failed(error);
            return;
        }
        try {
            this.end(await mesh({...withSites(options, this.sites), maxIterations: 0}));
        } catch (fault) {
            this.seen.failed(fault);
        }
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
        this.result = null;
    }
}

function withSites(options, sites) {
    const {symmetry, start, ...others} = options;
    return {...others, sites};
}
