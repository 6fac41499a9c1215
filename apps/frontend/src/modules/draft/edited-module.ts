import { computed, type ComputedRef } from 'vue';
import { splitText, type ModuleText } from '../text/module-text.ts';
import type { ModuleDraft } from './module-draft.ts';

/** A draft without its code. */
export type ModuleAbout = Omit<ModuleDraft, 'code'>;

/**
 * The draft of the editor by its parts. Each part changes only when it is edited: a key in the code draws nothing else
 * again. `draft` and `about` are read only while there is a draft.
 */
export interface EditedModule {
  readonly draft: ComputedRef<ModuleDraft>;
  readonly about: ComputedRef<ModuleAbout>;
  /** Empty without a draft. */
  readonly code: ComputedRef<string>;
  /** The code, split once for all who need its callbacks or problems. */
  readonly text: ComputedRef<ModuleText>;
}

export function editedModule(draft: () => ModuleDraft | undefined): EditedModule {
  const code = computed(() => draft()?.code ?? '');
  return {
    draft: computed(() => draft()!),
    about: computed<ModuleAbout>((before) => aboutOf(draft()!, before)),
    code,
    text: computed(() => splitText(code.value)),
  };
}

function aboutOf(
  { code: _code, ...about }: ModuleDraft,
  before: ModuleAbout | undefined,
): ModuleAbout {
  const members = Object.keys(about) as (keyof ModuleAbout)[];
  const isSame = before && members.every((member) => about[member] === before[member]);
  return isSame ? before : about;
}
