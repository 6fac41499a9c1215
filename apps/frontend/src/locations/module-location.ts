import type { RouteLocationRaw } from 'vue-router';

/** A name as a part of an address. */
const segment = (name: string): string => encodeURIComponent(name).replaceAll('.', '%2E');

/** Where a module is shown, by its name. */
export function moduleLocation(name: string): RouteLocationRaw {
  return { path: `/modules/${segment(name)}` };
}

/**
 * Where a module is written, by its name; with a name of unsaved work, that.
 * @param at a place in the code to go to, such as `onProcessing:7:12`
 */
export function moduleEditorLocation(name: string, at = ''): RouteLocationRaw {
  return { path: `/modules/${segment(name)}/edit`, ...(at !== '' && { query: { at } }) };
}
