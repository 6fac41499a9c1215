import * as v from 'valibot';
import { readStored } from '../../json/read-stored.ts';
import { finite, textOrNone } from '../../json/schemas.ts';
import type { ModuleDraft } from './module-draft.ts';

/** Unsaved changes, and the version they are based on. */
export interface KeptDraft {
  readonly draft: ModuleDraft;
  /** Version stored on the master; `undefined` for a module that was never saved. */
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
  // Drafts of earlier versions have no asset sets.
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

/** Returns the draft stored under the name in the URL; `undefined` without a valid one. */
export const readDraft = (name: string): KeptDraft | undefined =>
  readStored(KEPT, localStorage.getItem(PREFIX + name));

/** @returns false when the storage is full */
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

/** Sorted names of modules with unsaved changes. */
export function draftNames(): string[] {
  return Object.keys(localStorage)
    .filter((key) => key.startsWith(PREFIX))
    .map((key) => key.slice(PREFIX.length))
    .sort((a, b) => a.localeCompare(b));
}
