import type { InjectionKey, Ref, ShallowRef } from 'vue';

/** Load of this tab by modules of sessions. */
export interface TabNodeLoad {
  /** Number of running modules. */
  readonly instances: number;
  /** Total runs per second. */
  readonly runsPerSecond: number;
  /** Share of the time in which code of modules runs, 0 to 1; above 1 with several workers. */
  readonly load: number;
}

/** `off`; `starting` its workers; `on`; `failed` with a reason. */
export type TabNodeState =
  | { readonly status: 'off' | 'starting' | 'on' }
  | { readonly status: 'failed'; readonly reason: string };

/** This tab as a node. */
export interface TabNode {
  /** The user's choice for this tab; survives a reload. */
  readonly isChosen: Ref<boolean>;
  readonly state: Readonly<ShallowRef<TabNodeState>>;
  readonly load: Readonly<ShallowRef<TabNodeLoad>>;
  /**
   * Runs modules while a part of this page needs it, independent of the user's choice.
   * @returns a function that ends the need
   */
  need(): () => void;
  /** Resolves when the tab can run modules; rejects with a sentence when it cannot. */
  whenOn(): Promise<void>;
}

export const TAB_NODE: InjectionKey<TabNode> = Symbol('tab node');

/** Explanation in one sentence. */
export const TAB_NODE_SENTENCE =
  'Sessions can run processing modules in this tab. The modules run in workers without access to the page or the network, until the tab is closed.';
