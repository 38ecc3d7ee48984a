/** The user's own table, of sites or of sizes: chosen as a file or dropped on the page. */

const MOST_BYTES = 2 ** 26;
/** Sites that are farther from the domain than this lie outside, in units of the period vectors. */
const MARGIN = 1e-9;

function element(id) {
    return document.getElementById(id);
}

/** Returns the number of sites outside of the parallelogram of the period vectors. */
export function numberOutside(sites, [ax, ay, bx, by]) {
    const area = ax * by - ay * bx;
    let n = 0;
    for (let k = 0; k < sites.length; k += 2) {
        const u = (sites[k] * by - sites[k + 1] * bx) / area;
        const v = (ax * sites[k + 1] - ay * sites[k]) / area;
        if (Math.min(u, v) < -MARGIN || Math.max(u, v) > 1 + MARGIN) ++n;
    }
    return n;
}

const ONE = {areas: 'area', diameters: 'diameter', radii: 'radius'};

/** What is said of sites outside of the period; nothing without one. */
function outsideInWords(outside, rows) {
    if (outside === 0) return '';
    const [lie, count] = outside === 1 ? ['lies', 'counts'] : ['lie', 'count'];
    const doubt = 2 * outside > rows ? ': the period vectors may be wrong' : '';
    return ` ${outside.toLocaleString('en')} of them ${lie} outside of the period and ${count} ` +
        `modulo the period vectors${doubt}.`;
}

/**
 * Returns what a table holds, in words, and which units the page assumes.
 * @param contents  as readTable() of the package gives them.
 * @param lattice   the four numbers of the period vectors.
 */
export function contentsInWords({use, rows, quantity, columns, unit, sites}, lattice) {
    const n = rows.toLocaleString('en'), isOne = columns.length === 1;
    const place = columns.length === 0 ?
        ', without a header' :
        ` from column${isOne ? '' : 's'} ${columns.join(', ')}`;
    if (use === 'sizes') {
        return `${n} ${rows === 1 ? ONE[quantity] : quantity}${place}${unit && ` in ${unit}`}, ` +
            'one for each site. The areas of the cells are scaled to the area of the period.';
    }
    return `${n} site${rows === 1 ? '' : 's'}${place}. Lengths are those of the period vectors` +
        (unit ? `, which are in ${unit} as well.` : '.') +
        outsideInWords(numberOutside(sites, lattice), rows);
}

/** The table of a page, with the elements whose ids begin with "table". */
export class Table {
    /**
     * @param readTable  of the package.
     * @param seen  {changed(rows), failed()}: another table, or none, with 0 rows; a table that
     *              cannot be read.
     */
    constructor(readTable, seen) {
        [this.readTable, this.seen] = [readTable, seen];
        this.number = 0;
        this.file = this.contents = null;
        this.connect();
    }

    connect() {
        const input = element('table-file');
        input.addEventListener('change', () => {
            if (input.files.length > 0) this.open(input.files);
        });
        // A file that has changed can be chosen again.
        input.addEventListener('click', () => {
            input.value = '';
        });
        for (const id of ['table', 'table-use']) {
            element(id).addEventListener('change', () => this.read());
        }
        element('table-remove').addEventListener('click', () => this.remove());
        this.takeDrops(window);
    }

    /** Takes the files that are dropped on a window: that of the page, or of a frame. */
    takeDrops(target) {
        const holdsFiles = (event) => [...event.dataTransfer?.types ?? []].includes('Files');
        const mark = (isOver) => document.body.classList.toggle('dropping', isOver);
        target.addEventListener('dragover', (event) => {
            if (!holdsFiles(event)) return;
            event.preventDefault();
            mark(true);
        });
        target.addEventListener('dragleave', (event) => {
            // The pointer has left the window, and not only an element for another.
            if (event.relatedTarget === null) mark(false);
        });
        target.addEventListener('drop', (event) => {
            if (!holdsFiles(event)) return;
            event.preventDefault();
            mark(false);
            element('table-file').files = event.dataTransfer.files;
            this.open(event.dataTransfer.files);
        });
    }

    /** Reads the only file of a list. */
    async open(files) {
        const number = ++this.number;
        this.contents = null;
        this.show();
        if (files.length !== 1) {
            this.fail(`${files.length} files; take one table`);
            return;
        }
        const [file] = files;
        if (file.size > MOST_BYTES) {
            this.fail(`${file.name}: more than 64 MiB, the most that this page reads; use the command`);
            return;
        }
        let bytes;
        try {
            bytes = new Uint8Array(await file.arrayBuffer());
        } catch (error) {
            if (number !== this.number) return;
            this.fail(`${file.name}: cannot read: ${error.message}; take a readable file`);
            return;
        }
        if (number !== this.number) return;
        this.file = {name: file.name, bytes};
        element('table').value = file.name;
        element('table-use').value = '';
        await this.read();
    }

    /** Reads the file, by the name and the use that the form gives. */
    async read() {
        const number = ++this.number;
        this.contents = null;
        this.show();
        let contents;
        try {
            contents = await this.readTable({
                table: element('table').value.trim(),
                files: this.files,
                use: element('table-use').value || undefined
            });
        } catch (error) {
            if (number === this.number) this.fail(error.message);
            return;
        }
        if (number !== this.number) return;
        this.contents = contents;
        this.show();
        this.seen.changed(contents.rows);
    }

    remove() {
        ++this.number;
        this.file = this.contents = null;
        this.show();
        element('table-file').value = '';
        element('table-file').focus();
        this.seen.changed(0);
    }

    fail(message) {
        this.contents = null;
        this.show();
        this.fault(message);
        this.seen.failed();
    }

    fault(message) {
        element('table-fault').textContent = message;
        if (message)
            element('table').setAttribute('aria-invalid', 'true');
        else
            element('table').removeAttribute('aria-invalid');
    }

    get files() {
        return {[this.file.name]: this.file.bytes};
    }

    /** Whether the form names a table that cannot be read. */
    get isFaulty() {
        return this.file !== null && this.contents === null;
    }

    /** Shows what is known of the table, without a fault. */
    show() {
        element('table-part').hidden = this.file === null;
        element('table-note').textContent = '';
        this.fault('');
        const use = this.contents?.use;
        element('sites').disabled = use === 'sites';
        element('areas').disabled = use === 'sizes';
        element('areas').placeholder = use === 'sizes' ? 'as in your table' : 'lognormal:0.4';
    }

    showNote(lattice) {
        if (this.contents === null) return;
        element('table-note').textContent = contentsInWords(this.contents, lattice);
    }

    /** Whether an error of a run concerns the table. */
    concerns({message}) {
        return this.contents !== null && message.startsWith(`${this.file.name}:`);
    }

    /** Returns the options of a run with this table in place of the fields that it replaces. */
    apply(options) {
        if (this.contents === null) return options;
        const {use, name} = this.contents, {files} = this, {sites, ...others} = options;
        return use === 'sites' ? {...others, input: name, files} : {...options, areas: name, files};
    }
}
