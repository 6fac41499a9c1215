import * as v from 'valibot';
import { readStored } from '../../../json/read-stored.ts';
import { finite, textOrNone } from '../../../json/schemas.ts';
import type { ModuleDraft } from './module-draft.ts';

/** Unsaved work: what is being written, and what it was made of. */
export interface KeptDraft {
  readonly draft: ModuleDraft;
  /** As it was at the master; `undefined` for a module that was never saved. */
  readonly base: ModuleDraft | undefined;
}

const PREFIX = 'ubii.moduleDraft.';

const NAMES = v.array(v.string());
const IOS = v.array(
  v.object({
    name: v.string(),
    format: v.string(),
    isList: v.boolean(),
    defaultJson: v.optional(v.string()),
    description: v.optional(v.string()),
    choices: v.optional(NAMES),
  }),
);
const DRAFT: v.GenericSchema<unknown, ModuleDraft> = v.object({
  name: v.string(),
  description: textOrNone,
  tags: NAMES,
  authors: NAMES,
  version: textOrNone,
  libraries: NAMES,
  // Drafts of before asset sets lack them.
  assets: v.fallback(NAMES, []),
  optionalAssets: v.fallback(NAMES, []),
  inputs: IOS,
  outputs: IOS,
  mode: v.object({
    kind: v.picklist(['frequency', 'trigger', 'lockstep', 'free']),
    hertz: finite,
    minDelayMs: finite,
    allInputsNeedUpdate: v.boolean(),
  }),
  code: v.string(),
});
const KEPT: v.GenericSchema<unknown, KeptDraft> = v.pipe(
  v.object({ draft: DRAFT, base: v.optional(DRAFT) }),
  v.transform(({ draft, base }) => ({ draft, base })),
);

/** What this browser keeps under the name in the address; `undefined` for nothing that can be read. */
export const readDraft = (name: string): KeptDraft | undefined =>
  readStored(KEPT, localStorage.getItem(PREFIX + name));

/** @returns whether there was room for it */
export function keepDraft(name: string, kept: KeptDraft): boolean {
  try {
    localStorage.setItem(PREFIX + name, JSON.stringify(kept));
    return true;
  } catch {
    return false;
  }
}

export function dropDraft(name: string): void {
  localStorage.removeItem(PREFIX + name);
}

/** Names of modules with unsaved work, in order. */
export function draftNames(): string[] {
  return Object.keys(localStorage)
    .filter((key) => key.startsWith(PREFIX))
    .map((key) => key.slice(PREFIX.length))
    .sort((a, b) => a.localeCompare(b));
}
