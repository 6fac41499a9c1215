/** Limits of sandboxes that no caller sets, each with its reason. Those of a request are in limits.ts. */

/**
 * Source of all callbacks of one module, bytes. A megabyte is far more than usual code, and small
 * enough to be parsed at once. [PM-57]
 */
export const MAX_SOURCE_BYTES = 1024 * 1024;

/**
 * Heap of a worker with trusted instances, bytes: what a detection model takes, and an end for a leak.
 * The engine counts objects, not the bytes of buffers.
 */
export const TRUSTED_HEAP_BYTES = 512 * 1024 * 1024;

/**
 * Heap of a worker with sandboxed instances, bytes: their memory is not in it, but their results are
 * read in it, and the text of the largest is as long as an instance is allowed to be big.
 */
export const SANDBOXED_HEAP_BYTES = 256 * 1024 * 1024;

/** `onCreated` of trusted code and loading its libraries, milliseconds: models are read and compiled. */
export const TRUSTED_CREATE_TIMEOUT_MS = 30_000;

/**
 * Time of one call of a module with asset sets, milliseconds: a detection takes tenths of a second on a
 * phone, and as much again while a machine is busy.
 */
export const ASSET_CALL_TIMEOUT_MS = 5_000;

/** Waiting of one call for promises, such as an answer from the network, milliseconds. [PM-53] */
export const AWAIT_TIMEOUT_MS = 10_000;

/**
 * Maximum silence of a worker beyond the time of its call, milliseconds. QuickJS ends the call itself
 * and knows the line; only when it does not, the worker is ended.
 */
export const WATCHDOG_GRACE_MS = 250;

/** Interval of the watchdog's checks during calls, milliseconds. */
export const WATCHDOG_INTERVAL_MS = 50;

/** Log lines of one call that leave the worker; what is said beyond is counted. */
export const MAX_LOG_LINES_PER_CALL = 100;

/** Characters of a log line, and of the message of a fault. */
export const MAX_TEXT_LENGTH = 2_000;

/** Calls of a host's library under way at once, of one instance. */
export const MAX_LIBRARY_CALLS = 16;
