import type { JsonObject } from '@ubii/proto';
import * as v from 'valibot';
import {
  importedValue,
  readImported,
  type Imported,
  type ImportKind,
} from '../../../json/read-imported.ts';
import { readStored } from '../../../json/read-stored.ts';
import { finite, jsonObject, textCutAt, textUpTo } from '../../../json/schemas.ts';
import { MAX_TOPIC } from '../../plot/plot-settings.ts';
import {
  clampShare,
  isSplit,
  MAX_NAME,
  MAX_PANELS,
  panelsOf,
  type Layout,
  type LayoutNode,
} from './layout.ts';

const TYPE = 'ubi-interact-layout';
const VERSION = 1;
/** Longest JSON of a panel's settings, characters. */
const MAX_SETTINGS = 8000;
/** Longest file, characters. */
export const MAX_FILE = 200_000;

/** Converts a layout to the JSON of files. */
export function layoutJson({ name, root }: Layout): JsonObject {
  return { type: TYPE, version: VERSION, name, ...(root ? { root: nodeJson(root) } : {}) };
}

function nodeJson(node: LayoutNode): JsonObject {
  if (isSplit(node)) {
    const { direction, share, first, second } = node;
    return {
      split: direction,
      share: Math.round(share * 1000) / 1000,
      first: nodeJson(first),
      second: nodeJson(second),
    };
  }
  const { id, viewer, topic, settings } = node;
  return {
    panel: id,
    topic,
    ...(viewer === '' ? {} : { viewer }),
    ...(Object.keys(settings).length === 0 ? {} : { settings: { ...settings } }),
  };
}

const KIND: ImportKind = {
  what: 'layout of panels',
  mark: ['type', TYPE],
  version: ['version', VERSION],
  maxChars: MAX_FILE,
};

const NODE: v.GenericSchema<unknown, LayoutNode> = v.lazy((json) =>
  typeof json === 'object' && json !== null && 'split' in json ? SPLIT : PANEL,
);

const SPLIT: v.GenericSchema<unknown, LayoutNode> = v.pipe(
  v.object({
    split: v.picklist(['row', 'column']),
    share: v.pipe(finite, v.transform(clampShare)),
    first: NODE,
    second: NODE,
  }),
  v.transform(({ split, ...node }) => ({ direction: split, ...node })),
);

const PANEL: v.GenericSchema<unknown, LayoutNode> = v.pipe(
  v.object({
    panel: v.pipe(v.string(), v.regex(/^[\w-]{1,40}$/, 'should have 1 to 40 letters and digits')),
    topic: textUpTo(MAX_TOPIC),
    viewer: v.optional(textUpTo(40), ''),
    settings: v.optional(
      v.pipe(
        jsonObject,
        v.check((json) => JSON.stringify(json).length <= MAX_SETTINGS, 'is too large'),
      ),
      {},
    ),
  }),
  v.transform(({ panel, ...rest }) => ({ id: panel, ...rest })),
);

const LAYOUT = v.pipe(
  v.object({ name: textCutAt(MAX_NAME), root: v.optional(NODE) }),
  v.transform(({ name, root }): Layout => ({ name, root })),
  v.check(
    ({ root }) => panelsOf(root).length <= MAX_PANELS,
    ({ input: { root } }) =>
      `the layout has ${panelsOf(root).length} panels; a page shows up to ${MAX_PANELS}.`,
  ),
  v.check(({ root }) => {
    const ids = panelsOf(root).map(({ id }) => id);
    return new Set(ids).size === ids.length;
  }, 'two panels have the same id.'),
);

/** Parses a layout stored in this browser; undefined when it is invalid. */
export const storedLayout = (text: string): Layout | undefined => readStored(LAYOUT, text);

export const readLayoutFile = (text: string): Imported<Layout> => readImported(KIND, LAYOUT, text);

/** Reads the untrusted content of a link. */
export const linkedLayout = (json: unknown): Imported<Layout> =>
  importedValue(KIND, LAYOUT, json, 'link');

/** Reads the untrusted layout that is saved with a session. */
export const savedLayout = (json: unknown): Imported<Layout> =>
  importedValue(KIND, LAYOUT, json, 'session');
