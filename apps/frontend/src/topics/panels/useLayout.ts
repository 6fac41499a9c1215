import { useLocalStorage, useSessionStorage, watchDebounced } from '@vueuse/core';
import * as v from 'valibot';
import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';
import { useRoute, useRouter } from 'vue-router';
import { layoutJson, readLayoutFile, storedLayout } from './layout/layout-json.ts';
import type { Imported } from '../../json/read-imported.ts';
import { storedAs } from '../../json/read-stored.ts';
import { textOrNone, validMembers } from '../../json/schemas.ts';
import { layoutHash, layoutOfHash } from './layout/layout-link.ts';
import {
  firstStep,
  nextStep,
  redoStep,
  undoStep,
  type LayoutSteps,
} from './layout/layout-steps.ts';
import { EMPTY_LAYOUT, type Layout, type LayoutNode } from './layout/layout.ts';

/** The address follows the layout after this long, milliseconds: browsers refuse more often. */
const LINK_MS = 250;
/** Layouts that are kept by name in this browser. */
const MAX_SAVED = 50;

type NamedLayouts = Readonly<Record<string, string>>;
const storedNamed = storedAs<v.GenericSchema<unknown, NamedLayouts>>(validMembers(v.string()), {});

/** What a tab has made of its address. */
const OF_TAB = v.object({
  address: textOrNone,
  before: textOrNone,
  layout: textOrNone,
});

export interface LayoutStore {
  readonly layout: ComputedRef<Layout>;
  readonly canUndo: ComputedRef<boolean>;
  readonly canRedo: ComputedRef<boolean>;
  /** Names of layouts that are kept in this browser, in order. */
  readonly saved: ComputedRef<readonly string[]>;
  /** The end of the address that holds this layout; empty without panels, `undefined` when it is too large for one. */
  readonly hash: ComputedRef<string | undefined>;
  /** What is wrong with the file or link that was opened last. */
  readonly problem: ShallowRef<string | undefined>;
  /** @param gesture moves of the same gesture are one step */
  change(root: LayoutNode | undefined, gesture?: string): void;
  open(layout: Layout): void;
  openFile(text: string): void;
  openSaved(name: string): void;
  save(name: string): void;
  forget(name: string): void;
  complain(text: string): void;
  undo(): void;
  redo(): void;
}

/** The layout of the page: in the address, and kept in this browser for when there is none. */
export function useLayout(): LayoutStore {
  const route = useRoute();
  const router = useRouter();
  const kept = useLocalStorage<string>('ubii.panels', '');
  // The address lags behind: what this tab had made of it is newer than what it says after a reload.
  // While one address takes the place of another, a reload finds either.
  const ofTab = useSessionStorage('ubii.panelsOfTab', v.parse(OF_TAB, {}), {
    serializer: storedAs(OF_TAB, {}),
  });
  const named = useLocalStorage<NamedLayouts>('ubii.panelLayouts', {}, { serializer: storedNamed });
  const problem = shallowRef<string>();

  function taken(read: Imported<Layout> | undefined): Layout | undefined {
    problem.value = read?.kind === 'broken' ? `${read.message} Nothing was changed.` : undefined;
    return read?.kind === 'read' ? read.value : undefined;
  }

  const isOwn = (address: string): boolean =>
    address === ofTab.value.address || address === ofTab.value.before;
  const ofLink =
    (route.hash !== '' && isOwn(route.hash) ? storedLayout(ofTab.value.layout) : undefined) ??
    taken(layoutOfHash(route.hash));
  const before = storedLayout(kept.value) ?? EMPTY_LAYOUT;
  let first: LayoutSteps = firstStep(before);
  // What was open before the link is one step back.
  if (ofLink) first = nextStep(first, ofLink, false);
  const steps = shallowRef(first);
  const layout = computed(() => steps.value.present);
  const hash = computed(() => (layout.value.root ? layoutHash(layout.value) : ''));
  let lastGesture: string | undefined;

  function set(next: Layout, gesture?: string): void {
    const isSame = gesture !== undefined && gesture === lastGesture;
    lastGesture = gesture;
    steps.value = nextStep(steps.value, next, isSame);
  }

  // Kept at once, for the page may be left; the address follows.
  ofTab.value.address = ofTab.value.before = route.hash;
  watch(
    layout,
    (next) => {
      kept.value = JSON.stringify(layoutJson(next));
      ofTab.value.layout = kept.value;
    },
    { immediate: true },
  );
  watchDebounced(
    hash,
    (next = '') => {
      if (next === route.hash) return;
      ofTab.value.before = route.hash;
      ofTab.value.address = next;
      void router.replace({ path: '/panels', hash: next }).then(() => {
        if (route.hash === next) ofTab.value.before = next;
      });
    },
    { debounce: LINK_MS, immediate: true },
  );
  // A link that is pasted into the page's own address. What the page itself has put there may be of
  // the past by the time it stands there.
  watch(
    () => route.hash,
    (next) => {
      if (next === '' || next === ofTab.value.address || route.path !== '/panels') return;
      ofTab.value.address = ofTab.value.before = next;
      const linked = taken(layoutOfHash(next));
      if (linked && layoutHash(linked) !== hash.value) set(linked);
    },
  );

  return {
    layout,
    hash,
    problem,
    canUndo: computed(() => steps.value.past.length > 0),
    canRedo: computed(() => steps.value.future.length > 0),
    saved: computed(() => Object.keys(named.value).sort((a, b) => a.localeCompare(b))),
    change: (root, gesture) => set({ ...layout.value, root }, gesture),
    open: (next) => set(next),
    openFile(text) {
      const next = taken(readLayoutFile(text));
      if (next) set(next);
    },
    openSaved(name) {
      const next = taken(readLayoutFile(named.value[name] ?? ''));
      if (next) set(next);
    },
    save(name) {
      const next = { ...layout.value, name };
      set(next);
      const all = { ...named.value, [name]: JSON.stringify(layoutJson(next)) };
      named.value = Object.fromEntries(Object.entries(all).slice(-MAX_SAVED));
    },
    forget(name) {
      named.value = Object.fromEntries(
        Object.entries(named.value).filter(([other]) => other !== name),
      );
    },
    complain: (text) => (problem.value = text),
    undo: () => {
      lastGesture = undefined;
      steps.value = undoStep(steps.value);
    },
    redo: () => {
      lastGesture = undefined;
      steps.value = redoStep(steps.value);
    },
  };
}
