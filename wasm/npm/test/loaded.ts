/** The package as it is published, with the module that LIBRATION_MODULE names: `simd` (the default) or `scalar`. */

import { strict as assert } from "node:assert";
import { readFile } from "node:fs/promises";
import { load, loadSecond, usesVectors } from "libration";
import { ROOT } from "./ruler.js";

const scalar = process.env["LIBRATION_MODULE"] === "scalar";
await load(scalar ? { scalar: await readFile(new URL("wasm/npm/dist/libration-scalar.wasm", ROOT)) } : {});
await loadSecond();
assert.equal(usesVectors(), !scalar);

export * from "libration";
