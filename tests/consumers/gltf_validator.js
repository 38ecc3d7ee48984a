// Validates each file and exits with 1 on any error or warning. The script gltf_validator runs it.
const fs = require('fs');
const validator = require('gltf-validator');

const kSeverity = ['error', 'warning'];

async function countFaults(path) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(path)), {uri: path});
    for (const fault of report.issues.messages.filter((m) => m.severity < kSeverity.length)) {
        const place = fault.pointer ?? `byte ${fault.offset}`;
        console.log(`${path}: ${kSeverity[fault.severity]} ${fault.code} at ${place}: ${fault.message}`);
    }
    const {numErrors, numWarnings, numInfos} = report.issues;
    console.log(`${path}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} notes`);
    return numErrors + numWarnings;
}

async function main(paths) {
    let faults = 0;
    for (const path of paths) faults += await countFaults(path);
    process.exitCode = faults > 0 ? 1 : 0;
}

main(process.argv.slice(2)).catch((fault) => {
    console.error(`gltf_validator: ${fault}`);
    process.exitCode = 1;
});
