/** The module of springs and friction: it is loaded by itself, and needs no other one. */

import { type Core, type Source, started } from "./core.js";
import type { MotionExports } from "./exports.js";

let loaded: Core<MotionExports> | undefined;
let loading: Promise<void> | undefined;

/** @internal The module; an error where `loadMotions` has not ended. */
export function motions(): Core<MotionExports> {
  if (!loaded) throw new Error("springs and friction are in a module of their own: await loadMotions() first");
  return loaded;
}

/**
 * Loads springs and friction: `Duffing`, `CubicQuintic` and `DampedPendulum`. It does not need `load`.
 *
 * @param source Where the module comes from, if not from the package.
 * @throws Error where it cannot be read or compiled; a later call may try again.
 *
 * @example
 * import { Duffing, loadMotions } from "libration";
 * await loadMotions();
 * console.log(new Duffing({ u0: 1, p: 1, q: 1 }).period); // 4.768022...
 */
export function loadMotions(source?: Source): Promise<void> {
  loading ??= started<MotionExports>(source ?? new URL("./libration-motions.wasm", import.meta.url), false)
    .then((made) => {
      loaded = made;
    })
    .catch((error: unknown) => {
      loading = undefined;
      throw error;
    });
  return loading;
}
