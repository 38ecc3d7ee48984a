// Serves the files of a folder on the loopback address.
const fs = require('fs');
const http = require('http');
const path = require('path');

const kTypes = {
    '.css': 'text/css',
    '.html': 'text/html',
    '.js': 'text/javascript',
    '.mjs': 'text/javascript',
    '.wasm': 'application/wasm',
};

// Calls use(address) while a server sends the files.
async function withServer(folder, use) {
    const server = http.createServer((request, response) => {
        const name = decodeURIComponent(new URL(request.url, 'http://x').pathname);
        const file = path.join(folder, name.endsWith('/') ? `${name}index.html` : name);
        fs.readFile(file, (fault, bytes) => {
            response.writeHead(fault ? 404 : 200, {'Content-Type': kTypes[path.extname(file)] ?? 'text/plain'});
            response.end(bytes);
        });
    });
    await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
    try {
        await use(`http://127.0.0.1:${server.address().port}/`);
    } finally {
        server.closeAllConnections();
        server.close();
    }
}

module.exports = {withServer};
