import { useLocalStorage, useSessionStorage, watchDebounced } from '@vueuse/core';
import * as v from 'valibot';
import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';
import { useRoute, useRouter } from 'vue-router';
import { layoutJson, readLayoutFile, savedLayout, storedLayout } from './layout/layout-json.ts';
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

/** Delay before the URL follows the layout, milliseconds: browsers limit the rate of changes. */
const LINK_MS = 250;
/** Most named layouts stored in this browser. */
const MAX_SAVED = 50;

type NamedLayouts = Readonly<Record<string, string>>;
const storedNamed = storedAs<v.GenericSchema<unknown, NamedLayouts>>(validMembers(v.string()), {});

/** Most URLs of this tab that are taken for its layout: in Firefox, a reload sees one that was replaced a while ago. */
const MAX_OWN = 4;

/** State of this tab: its layout, and the hashes of the URLs that belong to it, newest last. */
const OF_TAB = v.object({
  addresses: v.optional(v.array(v.string()), []),
  layout: textOrNone,
});

export interface LayoutStore {
  readonly layout: ComputedRef<Layout>;
  readonly canUndo: ComputedRef<boolean>;
  readonly canRedo: ComputedRef<boolean>;
  /** Sorted names of the layouts stored in this browser. */
  readonly saved: ComputedRef<readonly string[]>;
  /** URL hash with this layout; empty without panels, `undefined` when it is too large for a URL. */
  readonly hash: ComputedRef<string | undefined>;
  /** Error of the file or link that was opened last. */
  readonly problem: ShallowRef<string | undefined>;
  /** @param gesture changes of the same gesture are one step */
  change(root: LayoutNode | undefined, gesture?: string): void;
  open(layout: Layout): void;
  openFile(text: string): void;
  /** Opens untrusted JSON, such as that of a session. */
  openJson(json: unknown): void;
  openSaved(name: string): void;
  save(name: string): void;
  forget(name: string): void;
  complain(text: string): void;
  undo(): void;
  redo(): void;
}

/** The layout of the page, in the URL; the last one is also stored in this browser, for URLs without one. */
export function useLayout(): LayoutStore {
  const route = useRoute();
  const router = useRouter();
  const kept = useLocalStorage<string>('ubii.panels', '');
  // The URL lags behind the layout: after a reload, this tab's stored layout is newer.
  const ofTab = useSessionStorage('ubii.panelsOfTab', v.parse(OF_TAB, {}), {
    serializer: storedAs(OF_TAB, {}),
  });
  const named = useLocalStorage<NamedLayouts>('ubii.panelLayouts', {}, { serializer: storedNamed });
  const problem = shallowRef<string>();

  function taken(read: Imported<Layout> | undefined): Layout | undefined {
    problem.value = read?.kind === 'broken' ? `${read.message} Nothing was changed.` : undefined;
    return read?.kind === 'read' ? read.value : undefined;
  }

  const isOwn = route.hash !== '' && ofTab.value.addresses.includes(route.hash);
  const ofLink =
    (isOwn ? storedLayout(ofTab.value.layout) : undefined) ?? taken(layoutOfHash(route.hash));
  const before = storedLayout(kept.value) ?? EMPTY_LAYOUT;
  let first: LayoutSteps = firstStep(before);
  // The layout before the link is one undo step back.
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

  // Stored at once, because the page may be left; the URL follows.
  ofTab.value.addresses = [route.hash];
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
      ofTab.value.addresses = [...ofTab.value.addresses, next].slice(-MAX_OWN);
      void router.replace({ path: '/panels', hash: next });
    },
    { debounce: LINK_MS, immediate: true },
  );
  // Opens a link pasted into the address bar. The page's own URLs may be outdated by the time the route changes.
  watch(
    () => route.hash,
    (next) => {
      const newest = ofTab.value.addresses.at(-1);
      if (next === '' || next === newest || route.path !== '/panels') return;
      ofTab.value.addresses = [next];
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
    openJson(json) {
      const next = taken(savedLayout(json));
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
