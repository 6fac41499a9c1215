import type { ModuleDraft } from './module-draft.ts';

/** Unsaved work: what is being written, and what it was made of. */
export interface KeptDraft {
  readonly draft: ModuleDraft;
  /** As it was at the master; `undefined` for a module that was never saved. */
  readonly base: ModuleDraft | undefined;
}

const PREFIX = 'ubii.moduleDraft.';

function isDraft(value: unknown): value is ModuleDraft {
  const draft = value as Partial<ModuleDraft> | null | undefined;
  return (
    typeof draft === 'object' &&
    draft !== null &&
    typeof draft.name === 'string' &&
    typeof draft.code === 'string' &&
    [draft.tags, draft.authors, draft.libraries, draft.inputs, draft.outputs].every(
      Array.isArray,
    ) &&
    typeof draft.mode?.kind === 'string'
  );
}

/** What this browser keeps under the name in the address; `undefined` for nothing that can be read. */
export function readDraft(name: string): KeptDraft | undefined {
  const text = localStorage.getItem(PREFIX + name);
  if (text === null) return undefined;
  try {
    const kept = JSON.parse(text) as Partial<KeptDraft>;
    if (!isDraft(kept.draft) || (kept.base !== undefined && !isDraft(kept.base))) return undefined;
    return { draft: whole(kept.draft), base: kept.base && whole(kept.base) };
  } catch {
    return undefined;
  }
}

/** Drafts of before asset sets lack them. */
const whole = (draft: ModuleDraft): ModuleDraft => ({
  ...draft,
  assets: draft.assets ?? [],
  optionalAssets: draft.optionalAssets ?? [],
});

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
