/**
 * The WebAssembly core: which module is loaded, and how arrays go in and out of it.
 *
 * A processor with 128-bit vectors gets the module that uses them, another one the scalar module; the digits are the same.
 * Arrays go through a workspace of fixed columns in blocks, so the memory of the module does not grow with them.
 */

import type { Exchange, Exports } from "./exports.js";

/** Where a module comes from: bytes, a compiled module, an address (also `data:...;base64,...`), or a response. */
export type Source =
  | ArrayBuffer
  | ArrayBufferView<ArrayBuffer>
  | WebAssembly.Module
  | URL
  | string
  | Response
  | PromiseLike<Response>;

/** One module for processors with vectors and one for those without; only the one that fits is fetched. */
export interface Sources {
  /** With vectors of 128 bits (the WebAssembly proposal simd128). */
  simd?: Source;
  /** Without. */
  scalar?: Source;
}

/** What the second module adds to the formulas of the angle, by their names. */
const SECOND: readonly string[] = ["small-m", "small-m-bounded", "cubic", "cubic-quintic"];

/** Numbers to be worked on: any array of numbers. Float64Array is copied fastest. */
export type Numbers = ArrayLike<number>;

/**
 * A refused argument, in the words of the core: `theta0 = NaN: must be finite`.
 *
 * @example
 * try {
 *   new Pendulum({ theta0: 1, length: -1 });
 * } catch (error) {
 *   if (error instanceof DomainError) console.log(error.argument, error.allowed); // length finite and positive
 * }
 */
export class DomainError extends RangeError {
  override readonly name = "DomainError";
  /** Name of the argument. */
  readonly argument: string;
  /** Its value, as text. */
  readonly given: string;
  /** What is allowed, to be read after "must be". */
  readonly allowed: string;

  /** Made by the package. */
  constructor(argument: string, given: string, allowed: string) {
    super(`${argument} = ${given}: must be ${allowed}`);
    this.argument = argument;
    this.given = given;
    this.allowed = allowed;
  }
}

/** The smallest module that uses vectors: one function that makes a vector and takes a lane of it. */
const VECTORS = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

/**
 * Whether this engine runs WebAssembly with vectors of 128 bits.
 *
 * @example
 * console.log(hasVectors() ? "two doubles at a time" : "one");
 */
export function hasVectors(): boolean {
  return WebAssembly.validate(VECTORS);
}

/** Columns of the workspace. */
const COLUMNS = 6;

/** A text of the core with its numbers, which it leaves as a mark and 16 hexadecimal digits of their bits. */
function written(text: string): string {
  return text.replace(/\u0001([0-9a-f]{16})/g, (_, bits: string) => shown(new Float64Array(BigUint64Array.of(BigInt(`0x${bits}`)).buffer)[0]!));
}

/** A number as Rust writes it in a message: `-1.0`, `0.001`, `1e-7`, `inf`. */
function shown(value: number): string {
  const size = value < 0 ? -value : value;
  if (Number.isNaN(value)) return "NaN";
  if (size === Number.POSITIVE_INFINITY) return value < 0 ? "-inf" : "inf";
  if (size > 0 && (size < 1e-4 || size >= 1e16)) return value.toExponential().replace("+", "");
  const sign = value < 0 || Object.is(value, -0) ? "-" : "";
  return Number.isInteger(size) ? `${sign}${size}.0` : `${sign}${size}`;
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** Copies a block of an array into a column. */
function fill(column: Float64Array, from: Numbers, at: number, count: number): void {
  if (from instanceof Float64Array) column.set(count === from.length ? from : from.subarray(at, at + count));
  else for (let i = 0; i < count; i++) column[i] = from[at + i]!;
}

/** A loaded module. */
export class Core<E extends Exchange = Exports> {
  readonly exports: E;
  /** Doubles in a column. */
  readonly rows: number;
  /** Whether it uses vectors. */
  readonly vectors: boolean;
  private views: Float64Array[] = [];

  constructor(instance: WebAssembly.Instance, vectors: boolean) {
    this.exports = instance.exports as unknown as E;
    this.rows = this.exports.rows();
    this.vectors = vectors;
  }

  /** Column i of the workspace; made again when the memory has grown, which ends old views. */
  column(i: number): Float64Array {
    if (this.views.length === 0 || this.views[0]!.byteLength === 0) {
      const { memory } = this.exports;
      const start = this.exports.columns();
      this.views = Array.from({ length: COLUMNS }, (_, at) => new Float64Array(memory.buffer, start + 8 * this.rows * at, this.rows));
    }
    return this.views[i]!;
  }

  /** The text that the core has left. */
  text(): string {
    const { memory } = this.exports;
    return decoder.decode(new Uint8Array(memory.buffer, this.exports.text(), this.exports.text_length()));
  }

  /** Writes the text that the core reads next. */
  say(text: string): void {
    const bytes = encoder.encode(text);
    const at = this.exports.text_room(bytes.length);
    new Uint8Array(this.exports.memory.buffer, at, bytes.length).set(bytes);
  }

  /** The refusal that the core has left. */
  refusal(): DomainError {
    const [argument = "", given = "", allowed = ""] = written(this.text()).split("\n");
    return new DomainError(argument, given, allowed);
  }

  /** The list of a length, or what was refused. */
  list(length: number): Float64Array {
    if (length < 0) throw this.refusal();
    return new Float64Array(this.exports.memory.buffer, this.exports.list(), length).slice();
  }

  /** Sends an array through column 0, and a second one through the last, in blocks; takes the next columns as results. */
  through(argument: Numbers, results: Float64Array[], work: (rows: number) => void, last?: Numbers): void {
    const { length } = argument;
    for (let from = 0; from < length; from += this.rows) {
      const count = Math.min(this.rows, length - from);
      fill(this.column(0), argument, from, count);
      if (last) fill(this.column(COLUMNS - 1), last, from, count);
      work(count);
      results.forEach((result, at) => {
        const filled = this.column(at + 1);
        result.set(count === this.rows ? filled : filled.subarray(0, count), from);
      });
    }
  }

  /** The first results for one number. */
  once(argument: number, work: (rows: number) => void): void {
    this.column(0)[0] = argument;
    work(1);
  }
}

let loaded: Core | undefined;
let loading: Promise<void> | undefined;
let second: Core | undefined;
let loadingSecond: Promise<void> | undefined;

/** The core; an error where `load` has not ended. */
export function core(): Core {
  if (!loaded) throw new Error("the core is not loaded: await load() first");
  return loaded;
}

/** The core that has a formula of the angle; an error where it is not loaded. */
export function coreOf(formula: string): Core {
  return SECOND.includes(formula) ? secondCore(formula) : core();
}

/** The core that has a function; an error where it is not loaded, which says what was asked for. */
export function coreWith(name: keyof Exports, asked: string): Core {
  return name in core().exports ? core() : secondCore(asked);
}

function secondCore(asked: string): Core {
  if (!second) throw new Error(`${asked} is in the second module: await loadSecond() first`);
  return second;
}

/**
 * Loads the core once; motions, approximations of the angle and numerical solutions work from then on, and at once. The rest
 * is in the second module: {@link loadSecond}.
 *
 * Without sources the modules that come with the package are taken, read from its folder in Node and fetched in a
 * browser. A second call changes nothing and waits for the first.
 *
 * @param sources Where the two modules come from; only the one that this engine needs is read.
 * @throws Error where a module cannot be read or compiled; a later call may try again.
 *
 * @example
 * import { load, Pendulum } from "libration";
 * await load();
 * console.log(new Pendulum({ theta0: 3, length: 1, gravity: 9.8 }).period); // 5.16069775...
 */
export function load(sources: Sources = {}): Promise<void> {
  loading ??= instance(sources).catch((error: unknown) => {
    loading = undefined;
    throw error;
  });
  return loading;
}

/**
 * Loads the second module, with what a page does not need at first: the formulas of the period, `ranges`, the elliptic
 * functions, and the approximations `small-m`, `small-m-bounded`, `cubic` and `cubic-quintic`, which are as large as all the rest.
 *
 * @param source Where it comes from, if not from the package.
 * @throws Error where it cannot be read or compiled; a later call may try again.
 *
 * @example
 * await loadSecond();
 * approx.angle("cubic").of(new Pendulum({ theta0: 1 })).theta(2); // -0.307...
 */
export function loadSecond(source?: Source): Promise<void> {
  loadingSecond ??= started(source ?? new URL("./libration-second.wasm", import.meta.url), false)
    .then((made) => {
      second = made;
    })
    .catch((error: unknown) => {
      loadingSecond = undefined;
      throw error;
    });
  return loadingSecond;
}

/**
 * Whether the loaded core uses vectors of 128 bits.
 *
 * @throws Error before `load` has ended.
 */
export function usesVectors(): boolean {
  return core().vectors;
}

/**
 * The version of the core.
 *
 * @throws Error before `load` has ended.
 */
export function version(): string {
  core().exports.version();
  return core().text();
}

async function instance(sources: Sources): Promise<void> {
  const vectors = sources.simd === undefined && sources.scalar !== undefined ? false : hasVectors();
  // Two addresses as they stand, so that bundlers find the files.
  const source = vectors
    ? (sources.simd ?? new URL("./libration-simd.wasm", import.meta.url))
    : (sources.scalar ?? new URL("./libration-scalar.wasm", import.meta.url));
  loaded = await started(source, vectors);
}

/** @internal A module of its own, at work. */
export async function started<E extends Exchange = Exports>(source: Source, vectors: boolean): Promise<Core<E>> {
  return new Core<E>(await WebAssembly.instantiate(await moduleOf(source), {}), vectors);
}

async function moduleOf(source: Source): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  if (typeof source === "string" || source instanceof URL) {
    const address = String(source);
    if (address.startsWith("data:")) return WebAssembly.compile(decoded(address));
    if (address.startsWith("file:") && "process" in globalThis) {
      const { readFile } = await import("node:fs/promises");
      return WebAssembly.compile(await readFile(new URL(address)));
    }
    return moduleOf(fetch(source));
  }
  const response = await source;
  if (!response.ok) throw new Error(`${response.url}: answered ${response.status}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** The bytes of a `data:` address in base64. */
function decoded(address: string): Uint8Array<ArrayBuffer> {
  const text = atob(address.slice(address.indexOf(",") + 1));
  return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
}

/** Drops what the core keeps for an object that JavaScript has forgotten. */
const forgotten = new FinalizationRegistry(({ number, drop }: Kept) => drop(number));

/** What the core keeps. */
interface Kept {
  number: number;
  drop: (number: number) => void;
}

/** The number of a new object of a core, dropped with its owner; throws what the core refuses. */
export function keep(owner: object, number: number, drop: (number: number) => void, of: Core<Exchange> = core()): number {
  if (number === 0) throw of.refusal();
  forgotten.register(owner, { number, drop }, owner);
  return number;
}

/** Drops what the core keeps for an object that is not forgotten yet. */
export function release(owner: object, number: number, drop: (number: number) => void): void {
  if (forgotten.unregister(owner)) drop(number);
}

/** The first result for a number or an array. */
export function first(
  argument: number | Numbers,
  out: Float64Array | undefined,
  work: (rows: number) => void,
  of: Core<Exchange> = core(),
): number | Float64Array {
  if (typeof argument === "number") {
    of.once(argument, work);
    return of.column(1)[0]!;
  }
  const result = out ?? new Float64Array(argument.length);
  of.through(argument, [result], work);
  return result;
}

/** The first two results for a number or an array. */
export function pair(
  argument: number | Numbers,
  out: [Float64Array, Float64Array] | undefined,
  work: (rows: number) => void,
  of: Core<Exchange> = core(),
): [number, number] | [Float64Array, Float64Array] {
  if (typeof argument === "number") {
    of.once(argument, work);
    return [of.column(1)[0]!, of.column(2)[0]!];
  }
  const results = out ?? [new Float64Array(argument.length), new Float64Array(argument.length)];
  of.through(argument, results, work);
  return results;
}
