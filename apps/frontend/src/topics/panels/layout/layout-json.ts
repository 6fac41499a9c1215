import type { JsonObject, JsonValue } from '@ubii/proto';
import { MAX_TOPIC } from '../../plot/plot-settings.ts';
import {
  clampShare,
  isSplit,
  MAX_NAME,
  MAX_PANELS,
  panelsOf,
  type Layout,
  type LayoutNode,
  type Panel,
} from './layout.ts';

const TYPE = 'ubi-interact-layout';
const VERSION = 1;
/** Letters of what one panel may set. */
const MAX_SETTINGS = 8000;
/** Splits within splits: more than panels are never needed. */
const MAX_DEPTH = MAX_PANELS;
/** Letters of a file. */
export const MAX_FILE = 200_000;

/** Why a file or a link is no layout: one sentence. */
export class LayoutError extends Error {
  override readonly name = 'LayoutError';
}

/** As files hold it. */
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

/** @throws LayoutError */
export function readLayoutFile(text: string): Layout {
  if (text.length > MAX_FILE) throw new LayoutError('This file is too large for a layout.');
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    throw new LayoutError('This file is not JSON. It may be cut off or damaged.');
  }
  return readLayout(json);
}

/** Reads an untrusted layout. @throws LayoutError */
export function readLayout(json: unknown): Layout {
  if (!isObject(json) || json['type'] !== TYPE) {
    throw new LayoutError('This is JSON, but not a layout of panels.');
  }
  const { version, name, root } = json;
  if (version !== VERSION) {
    throw new LayoutError(
      `This layout has version ${JSON.stringify(version)}; this page reads version ${VERSION}.`,
    );
  }
  const node = root === undefined ? undefined : readNode(root as JsonValue, 0);
  const panels = panelsOf(node);
  if (panels.length > MAX_PANELS) {
    throw new LayoutError(
      `This layout has ${panels.length} panels; a page shows up to ${MAX_PANELS}.`,
    );
  }
  if (new Set(panels.map(({ id }) => id)).size < panels.length) {
    throw new LayoutError('Two panels of this layout have the same id.');
  }
  return { name: typeof name === 'string' ? name.slice(0, MAX_NAME) : '', root: node };
}

function readNode(json: JsonValue, depth: number): LayoutNode {
  if (!isObject(json) || depth > MAX_DEPTH) throw new LayoutError(damaged('a part'));
  const { split, share, first, second } = json;
  if (split === undefined) return readPanel(json);
  if (split !== 'row' && split !== 'column') throw new LayoutError(damaged('a split'));
  if (typeof share !== 'number' || !Number.isFinite(share)) {
    throw new LayoutError(damaged('the share of a split'));
  }
  return {
    direction: split,
    share: clampShare(share),
    first: readNode(first ?? null, depth + 1),
    second: readNode(second ?? null, depth + 1),
  };
}

function readPanel({ panel, topic, viewer = '', settings = {} }: JsonObject): Panel {
  const isId = typeof panel === 'string' && /^[\w-]{1,40}$/.test(panel);
  if (!isId) throw new LayoutError(damaged('the id of a panel'));
  if (typeof topic !== 'string' || topic.length > MAX_TOPIC) {
    throw new LayoutError(damaged(`the topic of panel ${panel}`));
  }
  if (typeof viewer !== 'string' || viewer.length > 40) {
    throw new LayoutError(damaged(`the view of panel ${panel}`));
  }
  if (!isObject(settings) || JSON.stringify(settings).length > MAX_SETTINGS) {
    throw new LayoutError(damaged(`the settings of panel ${panel}`));
  }
  return { id: panel, topic, viewer, settings };
}

const damaged = (what: string): string => `This layout is damaged: ${what} is not valid.`;

function isObject(json: unknown): json is JsonObject {
  return typeof json === 'object' && json !== null && !Array.isArray(json);
}
