// Reads each file by three.js' own loader and exits with 1 unless its triangles cover the area of
// the period parallelogram and, in .glb and .obj, u a + v b is the position of each corner (with v
// upwards), so that a picture lies upright on the tile. The script three_js runs it.
import fs from 'node:fs';
import * as three from 'three';
import {GLTFLoader} from 'three/examples/jsm/loaders/GLTFLoader.js';
import {OBJLoader} from 'three/examples/jsm/loaders/OBJLoader.js';
import {PLYLoader} from 'three/examples/jsm/loaders/PLYLoader.js';

const kSingle = 2e-6;
globalThis.self = globalThis;

function require(holds, complaint) {
    if (!holds) throw new Error(complaint);
}

const lines = (path) => fs.readFileSync(path, 'latin1').split('\n');

// Returns ax, ay, bx, by of the comments of an .obj or a .ply.
function statedLattice(path) {
    const line = lines(path).find((text) => / pcvt lattice /.test(text) && !/ax/.test(text));
    return line.split(' lattice ')[1].split(' ').map(Number);
}

function meshesOf(root) {
    const meshes = [];
    root.traverse((node) => {
        if (node.isMesh) meshes.push(node);
    });
    return meshes;
}

// Returns the lattice, the geometries, and whether v points down in them.
async function load(path) {
    const bytes = fs.readFileSync(path);
    if (path.endsWith('.obj')) {
        const root = new OBJLoader().parse(bytes.toString('latin1'));
        return [statedLattice(path), meshesOf(root).map((mesh) => mesh.geometry), false];
    }
    if (path.endsWith('.ply')) {
        return [statedLattice(path), [new PLYLoader().parse(bytes.toString('latin1'))], null];
    }
    const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
    const file = await new GLTFLoader().parseAsync(buffer, '');
    const tile = file.scene.getObjectByName('tile');
    return [tile.userData.periodic.lattice.flat(), meshesOf(file.scene).map((m) => m.geometry), true];
}

function area(geometry) {
    const place = geometry.attributes.position;
    const corner = (k) => new three.Vector3().fromBufferAttribute(
        place, geometry.index ? geometry.index.getX(k) : k);
    const n = geometry.index ? geometry.index.count : place.count;
    let sum = 0;
    for (let k = 0; k < n; k += 3) {
        const [p, q, r] = [corner(k), corner(k + 1), corner(k + 2)];
        sum += q.sub(p).cross(r.sub(p)).z / 2;
    }
    return sum;
}

function requireTexture(geometry, [ax, ay, bx, by], isDown) {
    const {position, uv} = geometry.attributes;
    require(uv, 'there are no texture coordinates');
    const size = Math.max(...[ax, ay, bx, by].map(Math.abs));
    for (let k = 0; k < uv.count; ++k) {
        const [u, v] = [uv.getX(k), isDown ? 1 - uv.getY(k) : uv.getY(k)];
        const x = Math.abs(u * ax + v * bx - position.getX(k));
        const y = Math.abs(u * ay + v * by - position.getY(k));
        require(Math.max(x, y) < kSingle * size, `a texture coordinate is off by ${x}, ${y}`);
    }
}

async function check(path) {
    const [lattice, geometries, isDown] = await load(path);
    const [ax, ay, bx, by] = lattice;
    const wanted = Math.abs(ax * by - ay * bx);
    const found = geometries.reduce((sum, geometry) => sum + area(geometry), 0);
    require(Math.abs(found - wanted) < 1e-5 * wanted, `the area is ${found}, not ${wanted}`);
    if (isDown !== null) geometries.forEach((geometry) => requireTexture(geometry, lattice, isDown));
    // All parts of a .glb share their vertices.
    const shared = new Set(geometries.map((geometry) => geometry.attributes.position));
    require(!path.endsWith('.glb') || shared.size === 1, `${shared.size} lists of vertices`);
    console.log(`${path}: ${geometries.length} geometries, area ${found}`);
}

for (const path of process.argv.slice(2)) {
    await check(path).catch((fault) => {
        console.log(`${path}: ${fault.message}`);
        process.exitCode = 1;
    });
}
