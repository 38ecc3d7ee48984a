// Measures whether colours differ for readers with and without colour blindness.

// Machado, Oliveira and Fernandes (2009), severity 1, on linear sRGB.
const kVisions = {
    normal: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    protanopia: [
        [0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998]
    ],
    deuteranopia: [
        [0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413],
        [-0.01182, 0.04294, 0.968881]
    ],
};
const kXyzOfSrgb = [
    [0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.072175],
    [0.0193339, 0.119192, 0.9503041]
];
const kWhite = [0.95047, 1, 1.08883];
const kLeastDifference = 15;
// More classes of translations than these are rare.
const kSeams = 4;

function product(matrix, vector) {
    return matrix.map((row) => row.reduce((sum, value, k) => sum + value * vector[k], 0));
}

// Returns L*, a*, b* of "#rrggbb" as a reader with this vision sees it.
function labOf(hex, vision) {
    const linear = [1, 3, 5]
                       .map((k) => parseInt(hex.slice(k, k + 2), 16) / 255)
                       .map((c) => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    const seen = product(kVisions[vision], linear).map((c) => Math.min(1, Math.max(0, c)));
    const [x, y, z] =
        product(kXyzOfSrgb, seen)
            .map((value, k) => value / kWhite[k])
            .map((value) => value > 0.008856 ? Math.cbrt(value) : 7.787 * value + 16 / 116);
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

// Throws if two colours of the legend of a theme are nearer than kLeastDifference.
function checkColours(themes) {
    for (const [name, {sides, seams}] of Object.entries(themes)) {
        const colours = [...sides, ...seams.slice(0, kSeams)];
        for (const vision of Object.keys(kVisions)) {
            const labs = colours.map((colour) => labOf(colour, vision));
            for (let k = 0; k < colours.length; ++k) {
                for (let m = 0; m < k; ++m) {
                    const difference = Math.hypot(...labs[k].map((value, n) => value - labs[m][n]));
                    if (difference >= kLeastDifference) continue;
                    throw new Error(
                        `${name} theme, ${vision}: ${colours[m]} and ${colours[k]} ` +
                        `differ by ${difference.toFixed(1)}`);
                }
            }
        }
    }
}

module.exports = {checkColours};
