import type { UbiiClient } from '@ubii/client-web';
import type { NodeInstance, ProcessingNode } from '@ubii/client-web/processing';
import { until, useSessionStorage } from '@vueuse/core';
import { computed, shallowRef, watch } from 'vue';
import { perFrame } from '../connection/per-frame.ts';
import type { TabNode, TabNodeLoad, TabNodeState } from './tab-node.ts';

const IDLE: TabNodeLoad = { instances: 0, runsPerSecond: 0, load: 0 };

/** Total load of the modules in this tab. */
export function tabNodeLoad(instances: readonly Pick<NodeInstance, 'statistics'>[]): TabNodeLoad {
  const reports = instances.map(({ statistics }) => statistics);
  const sum = (of: (one: NonNullable<(typeof reports)[number]>) => number): number =>
    reports.reduce((total, one) => total + (one ? of(one) : 0), 0);
  return {
    instances: instances.length,
    runsPerSecond: sum((one) => one.runsPerSecond),
    load: sum((one) => (one.runsPerSecond * one.runP50Ms) / 1000),
  };
}

/**
 * This tab as a node. Workers and runtime are loaded on first use.
 * @param open creates the node without starting it
 */
export function createTabNode(
  client: UbiiClient,
  open: (client: UbiiClient) => Promise<ProcessingNode>,
): TabNode {
  const isChosen = useSessionStorage('ubii.tabRunsModules', false);
  const needs = shallowRef<ReadonlySet<symbol>>(new Set());
  const isWanted = computed(() => isChosen.value || needs.value.size > 0);
  const state = shallowRef<TabNodeState>({ status: 'off' });
  const load = shallowRef<TabNodeLoad>(IDLE);
  let node: ProcessingNode | undefined;
  /** Serialises changes, however fast the switch is toggled. */
  let changes: Promise<void> = Promise.resolve();

  async function openNode(): Promise<ProcessingNode> {
    const opened = await open(client);
    const draw = perFrame(() => (load.value = tabNodeLoad(opened.instances)));
    opened.onChange(draw);
    return opened;
  }

  /** Requested state; only the newest one is applied. */
  const wish = (): string => `${isWanted.value} ${isChosen.value}`;
  let applied = 'false false';

  async function apply(): Promise<void> {
    if (wish() === applied) return;
    applied = wish();
    try {
      if (isWanted.value) {
        if (state.value.status !== 'on') state.value = { status: 'starting' };
        node ??= await openNode();
        // Only with the user's permanent choice, the master may assign modules by itself.
        await node.setAcceptsWork(isChosen.value);
        await node.start();
        state.value = { status: 'on' };
      } else if (node?.isStarted) {
        await node.stop();
        load.value = IDLE;
        state.value = { status: 'off' };
      }
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      state.value = { status: 'failed', reason };
    }
  }
  watch(
    wish,
    () => {
      changes = changes.then(apply);
    },
    { immediate: true, flush: 'sync' },
  );

  return {
    isChosen,
    state,
    load,
    need() {
      const key = Symbol('need');
      needs.value = new Set([...needs.value, key]);
      return () => (needs.value = new Set([...needs.value].filter((other) => other !== key)));
    },
    async whenOn() {
      await changes;
      await until(state).toMatch(({ status }) => status === 'on' || status === 'failed');
      if (state.value.status === 'failed') throw new Error(state.value.reason);
    },
  };
}
