import { PAGE_BYTES } from '../memory-account.ts';

/**
 * Initial memory of a copy: 90 KiB of constants, a stack of 5 MiB, and a quarter of a megabyte for a runtime
 * with its first objects.
 */
export const INITIAL_PAGES = 86;
/**
 * Of the stack, which grows downwards, the engine's own limit lets it touch half a megabyte at most
 * (`stackBytes`): these pages are never touched, so that the system never gives them.
 */
export const UNTOUCHED_PAGES = 72;

/** Minimum memory of a sandboxed module, bytes: its copy of the engine. [PM-58] */
export const MIN_MODULE_BYTES = (INITIAL_PAGES - UNTOUCHED_PAGES) * PAGE_BYTES;
