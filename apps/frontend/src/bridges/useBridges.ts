import type { Client } from '@ubii/proto';
import { computed, onScopeDispose, shallowRef, triggerRef, watch, type ComputedRef } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { useTick } from '../ui/readouts/useTick.ts';
import {
  isFresh,
  NO_RATES,
  ratesBetween,
  sumRates,
  type DirectionRates,
  type TimedReport,
} from './model/bridge-rates.ts';
import { BRIDGE_TOPICS, bridgeOfTopic, readBridgeReport } from './model/bridge-report.ts';
import type { BridgeView } from './model/bridge-view.ts';

/** Start of the tag by which clients are known as bridges. [BR-22] */
const TAG = 'bridge to ';
/** Bridges whose reports are kept. */
const MAX_BRIDGES = 200;

interface Heard {
  readonly newest: TimedReport;
  readonly rates: ReadonlyMap<string, DirectionRates>;
}

/** The other system of a client that is a bridge; `undefined` for other clients. */
export function systemOf({ tags }: Pick<Client, 'tags'>): string | undefined {
  return tags.find((tag) => tag.startsWith(TAG))?.slice(TAG.length);
}

/** All bridges, by name; those that left stay until the page is left. `undefined` until the clients are known. */
export function useBridges(): ComputedRef<readonly BridgeView[] | undefined> {
  const { client, clients } = useConnection();
  const heard = shallowRef(new Map<string, Heard>());
  const known = new Map<string, { readonly name: string; readonly system: string }>();
  const now = useTick(1_000);

  const subscription = client.subscribe({ glob: BRIDGE_TOPICS }, { format: 'string' });
  subscription.onRecord(({ topic, value, clientId }) => {
    const id = bridgeOfTopic(topic);
    // No topic has the state of another client.
    if (id === undefined || clientId !== id) return;
    const before = heard.value.get(id);
    if (before === undefined && heard.value.size >= MAX_BRIDGES) return;
    const report = readBridgeReport(value);
    if (report === undefined) return;
    const newest = { report, atMs: performance.now() };
    heard.value.set(id, { newest, rates: ratesBetween(before?.newest, newest) });
    triggerRef(heard);
  });
  onScopeDispose(() => void subscription.close().catch(() => undefined));
  subscription.ready.catch(() => undefined);

  const here = computed(() => clients.list.value?.filter((one) => systemOf(one) !== undefined));
  watch(
    here,
    (list) => {
      for (const one of list ?? []) {
        if (known.size < MAX_BRIDGES || known.has(one.id)) {
          known.set(one.id, { name: one.name, system: systemOf(one) ?? '' });
        }
      }
    },
    { immediate: true },
  );

  return computed(() => {
    if (here.value === undefined) return undefined;
    const present = new Set(here.value.map(({ id }) => id));
    void now.value;
    const views = [...known].map(([id, { name, system }]): BridgeView => {
      const one = heard.value.get(id);
      const isHere = present.has(id);
      const isLive = isHere && one !== undefined && isFresh(one.newest, performance.now());
      const rates = isLive ? one.rates : new Map<string, DirectionRates>();
      const total = isLive ? sumRates(rates.values()) : NO_RATES;
      return { id, name, system, isHere, report: one?.newest.report, rates, total };
    });
    return views.sort((a, b) => (a.name < b.name ? -1 : a.name > b.name ? 1 : 0));
  });
}
