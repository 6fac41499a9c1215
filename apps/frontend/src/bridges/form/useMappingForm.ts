import { useDebounceFn } from '@vueuse/core';
import type { BridgeMappingProblem } from '@ubii/proto';
import { computed, reactive, ref, shallowRef, watch } from 'vue';
import { theirsOf, type MappingChange, type WrittenMapping } from '../model/mapping-changes.ts';
import { draftOf, isUnchanged, mappingOf, type DraftMember } from '../model/mapping-draft.ts';
import type { BridgeMappingsStore, CheckResult } from '../useBridgeMappings.ts';

/** Pause after the last key before the bridge is asked. */
const CHECK_AFTER_MS = 300;

/** What a form for a mapping is about. */
export interface MappingFormOptions {
  readonly store: BridgeMappingsStore;
  readonly protocol: string;
  /** The mapping as it was when the form was opened; `undefined` for a new one. */
  readonly before: WrittenMapping | undefined;
  readonly index: number;
  readonly onSaved: (change: MappingChange, index: number) => void;
}

/** State of a form for a mapping: what is typed, what the bridge says about it, and what others did meanwhile. */
export function useMappingForm(options: MappingFormOptions) {
  const { store, protocol, index, onSaved } = options;
  /** What the change replaces; another one once the user keeps their own version of a conflict. */
  const base = shallowRef(options.before);
  const draft = reactive(draftOf(options.before));
  const touched = reactive(new Set<string>());
  const wantsAll = ref(false);
  const result = shallowRef<CheckResult>();
  const failure = ref<string>();
  const isSaving = ref(false);
  /** Another user changed (`mapping`) or removed (`undefined`) it. */
  const conflict = shallowRef<{ readonly theirs: WrittenMapping | undefined }>();
  let turn = 0;

  const mapping = computed(() => mappingOf(draft, protocol, base.value));
  function changeOf(): MappingChange {
    const before = base.value;
    return before === undefined
      ? { kind: 'add', mapping: mapping.value, index }
      : { kind: 'replace', before, mapping: mapping.value, index };
  }

  async function check(): Promise<void> {
    const own = ++turn;
    const found = await store.check(changeOf());
    if (own === turn && found !== undefined) result.value = found;
  }
  const checkLater = useDebounceFn(() => void check(), CHECK_AFTER_MS);
  watch(mapping, (next, last) => {
    for (const member of new Set([...Object.keys(next), ...Object.keys(last)])) {
      if (next[member] !== last[member]) touched.add(member);
    }
    void checkLater();
  });
  void check();

  const shown = computed<readonly BridgeMappingProblem[]>(() =>
    (result.value?.problems ?? []).filter(({ member }) => wantsAll.value || touched.has(member)),
  );
  function errorOf(member: DraftMember): string | undefined {
    return shown.value.find((problem) => problem.member === member)?.message;
  }
  /** Problems that no field shows. */
  const otherProblems = computed(() =>
    shown.value.filter(({ member }) => !(member in draft)).map(({ message }) => message),
  );

  async function save(): Promise<void> {
    if (isSaving.value) return;
    isSaving.value = true;
    failure.value = undefined;
    wantsAll.value = true;
    const change = changeOf();
    const saved = await store.save(change);
    isSaving.value = false;
    if (saved.kind === 'saved') return onSaved(change, saved.index);
    if (saved.kind === 'failed') failure.value = saved.message;
    else if (saved.kind === 'refused') {
      turn += 1;
      result.value = { matches: [], moreMatches: 0, ...result.value, problems: saved.problems };
    } else if (base.value !== undefined) {
      conflict.value = { theirs: theirsOf(store.loaded.value?.list ?? [], base.value) };
    } else failure.value = 'Others are changing the mappings right now. Try again.';
  }

  /** Saves over what others made of it, or adds it again. */
  function keepMine(): void {
    base.value = conflict.value?.theirs;
    conflict.value = undefined;
    void save();
  }
  /** Continues with what others made of it. */
  function takeTheirs(): void {
    base.value = conflict.value?.theirs;
    conflict.value = undefined;
    Object.assign(draft, draftOf(base.value));
  }

  return {
    draft,
    result,
    failure,
    isSaving,
    conflict,
    otherProblems,
    errorOf,
    save,
    keepMine,
    takeTheirs,
    isUnchanged: computed(
      () => base.value !== undefined && isUnchanged(draft, protocol, base.value),
    ),
  };
}
