import { ModuleOrigin, type NodeInfo, type ProcessingModule, type Session } from '@ubii/proto';
import { formatLook } from '../../formats/families.ts';

/** Module of the library, with the nodes that offer it and the sessions that use it. */
export interface ModuleEntry {
  readonly module: ProcessingModule;
  readonly origin: ModuleOrigin;
  /** Nodes that have its code. */
  readonly offeredBy: readonly NodeInfo[];
  /** Sessions with a module of this name. */
  readonly usedBy: readonly Session[];
}

/** Display texts of origins. */
export const ORIGIN_WORDS: Readonly<Record<ModuleOrigin, string>> = {
  [ModuleOrigin.MODULE_ORIGIN_UNKNOWN]: 'on the master',
  [ModuleOrigin.MODULE_ORIGIN_BUILT_IN]: 'built in',
  [ModuleOrigin.MODULE_ORIGIN_FOLDER]: 'operator’s folder',
  [ModuleOrigin.MODULE_ORIGIN_STORED]: 'stored',
  [ModuleOrigin.MODULE_ORIGIN_NODE]: 'offered by a client',
};

/** Only modules stored through a service can be deleted. [SE-22] */
export function isDeletable({ origin }: Pick<ModuleEntry, 'origin'>): boolean {
  return origin === ModuleOrigin.MODULE_ORIGIN_STORED;
}

/** Built in, or from the operator's folder: the master stores no other module of this name. [SE-22] */
export function isFixed({ origin }: Pick<ModuleEntry, 'origin'>): boolean {
  return (
    origin === ModuleOrigin.MODULE_ORIGIN_BUILT_IN || origin === ModuleOrigin.MODULE_ORIGIN_FOLDER
  );
}

export function moduleEntries(
  modules: readonly ProcessingModule[],
  nodes: readonly NodeInfo[],
  sessions: readonly Session[],
): ModuleEntry[] {
  return modules
    .map((module) => ({
      module,
      origin: module.extension?.origin ?? ModuleOrigin.MODULE_ORIGIN_UNKNOWN,
      offeredBy: nodes.filter(({ moduleNames }) => moduleNames.includes(module.name)),
      usedBy: sessions.filter(({ processingModules }) =>
        processingModules.some(({ name }) => name === module.name),
      ),
    }))
    .sort((a, b) => a.module.name.localeCompare(b.module.name) || a.origin - b.origin);
}

/** Search: words, data format, origin; empty for all. */
export interface ModuleSearch {
  readonly text: string;
  readonly format: string;
  readonly origin: ModuleOrigin | undefined;
}

export function filterModules(
  entries: readonly ModuleEntry[],
  { text, format, origin }: ModuleSearch,
): ModuleEntry[] {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  return entries.filter((entry) => {
    if (origin !== undefined && entry.origin !== origin) return false;
    if (format !== '' && !moduleFormats(entry.module).includes(format)) return false;
    const all = searchText(entry.module);
    return words.every((word) => all.includes(word));
  });
}

/** Short names of the data formats of inputs and outputs, without duplicates. */
export function moduleFormats({ inputs, outputs }: ProcessingModule): string[] {
  const texts = [...inputs, ...outputs].map(({ messageFormat }) => formatLook(messageFormat).text);
  return [...new Set(texts)].filter((text) => text !== '');
}

function searchText({ name, description, tags, authors }: ProcessingModule): string {
  return [name, description, ...tags, ...authors].join(' ').toLowerCase();
}
