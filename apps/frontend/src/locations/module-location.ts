import type { RouteLocationRaw } from 'vue-router';

/** Encodes a name as a segment of a URL. */
const segment = (name: string): string => encodeURIComponent(name).replaceAll('.', '%2E');

/** Location of a module, by its name. */
export function moduleLocation(name: string): RouteLocationRaw {
  return { path: `/modules/${segment(name)}` };
}

/**
 * Location of the editor of a module, by its name or that of an unsaved draft.
 * @param at position in the code to show, such as `onProcessing:7:12`
 */
export function moduleEditorLocation(name: string, at = ''): RouteLocationRaw {
  return { path: `/modules/${segment(name)}/edit`, ...(at !== '' && { query: { at } }) };
}
