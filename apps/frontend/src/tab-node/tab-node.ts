import type { InjectionKey, Ref, ShallowRef } from 'vue';

/** What this tab runs for others. */
export interface TabNodeLoad {
  /** Modules that run here now. */
  readonly instances: number;
  /** Runs of all of them per second. */
  readonly runsPerSecond: number;
  /** Share of the time in which code of modules runs, 0 to 1; more than 1 with several workers. */
  readonly load: number;
}

/** `off` · `starting` its workers · `on` · `failed` with a reason. */
export type TabNodeState =
  | { readonly status: 'off' | 'starting' | 'on' }
  | { readonly status: 'failed'; readonly reason: string };

/** This tab as a place where modules run. */
export interface TabNode {
  /** What people chose for this tab; it survives a reload. */
  readonly isChosen: Ref<boolean>;
  readonly state: Readonly<ShallowRef<TabNodeState>>;
  readonly load: Readonly<ShallowRef<TabNodeLoad>>;
  /**
   * Runs modules while a part of this page needs it, independent of the user's choice.
   * @returns ends the need
   */
  need(): () => void;
  /** Resolves when the tab can be given modules; rejects with a sentence when it cannot. */
  whenOn(): Promise<void>;
}

export const TAB_NODE: InjectionKey<TabNode> = Symbol('tab node');

/** What it means, in one sentence. */
export const TAB_NODE_SENTENCE =
  'Sessions can run processing modules in this tab. The modules run in workers without access to the page or the network, until the tab is closed.';
