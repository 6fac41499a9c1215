import { createClient, createTabIdentity } from '@ubii/client-web';
import {
  StorageSerializers,
  useDocumentVisibility,
  useLocalStorage,
  useSessionStorage,
} from '@vueuse/core';
import { computed, shallowRef, watch } from 'vue';
import { adoptName } from './adopt-name.ts';
import { describeAgent } from './agent-description.ts';
import { createClientReportsStore } from './client-reports-store.ts';
import { createClientsStore } from './clients-store.ts';
import type { Connection } from './connection.ts';
import { friendlyName } from './friendly-name.ts';
import { IDENTITY_KEY, NAME_KEY } from './hand-over.ts';
import { createMasterStatusStore } from './master-status-store.ts';
import { nameMasters } from './masters.ts';
import { createOwnMark, keptMark } from './own-mark.ts';
import { createNodesStore } from './nodes-store.ts';
import { tellOwnTab } from './own-tabs.ts';
import { tellPageState } from './page-state.ts';
import { createSessionsStore } from './sessions-store.ts';
import { numberedName, useTabName, type TabNumber } from './tab-name.ts';
import { createTopicStatisticsStore } from './topic-statistics-store.ts';

const DEFAULT_PUBLISH_INTERVAL_MS = 15;

/** Name of the frame that contains this page; undefined outside of frames. */
function frameName(): string | undefined {
  return window.parent === window ? undefined : window.name || 'frame';
}

/** Creates the client of this page and its stores. Call once, at the root. */
export function createConnection(): Connection {
  // The name belongs to the browser, the identity to the tab: each tab is a separate client. A frame shares the storage
  // of its parent page, and is a client with its own name.
  const frame = frameName();
  const ownName =
    frame === undefined
      ? useLocalStorage(NAME_KEY, friendlyName(Math.random), { flush: 'sync' })
      : useSessionStorage(`${NAME_KEY}.${frame}`, frame, { flush: 'sync' });
  const publishIntervalMs = useLocalStorage('ubii.publishIntervalMs', DEFAULT_PUBLISH_INTERVAL_MS);
  const identityKey = frame === undefined ? IDENTITY_KEY : `${IDENTITY_KEY}.${frame}`;
  const identity = createTabIdentity(identityKey, IDENTITY_KEY);
  const tabNumber = useSessionStorage<TabNumber | undefined>(`${identityKey}.number`, undefined, {
    serializer: StorageSerializers.object,
  });
  // A frame is another client than the person's page.
  const kept = frame === undefined ? keptMark(localStorage) : undefined;
  const client = createClient({
    name: numberedName(ownName.value, tabNumber.value?.number),
    description: describeAgent(navigator.userAgent),
    tags: ['browser'],
    identity,
    ...(kept === undefined ? {} : { mark: kept }),
    publishIntervalMs: publishIntervalMs.value,
  });

  const state = shallowRef(client.state);
  const roundTrip = shallowRef(client.roundTrip);
  client.onState((next) => (state.value = next));
  // It changes with every PING; do not update views while the page is hidden.
  const visibility = useDocumentVisibility();
  const showRoundTrip = (): void => {
    if (visibility.value === 'visible') roundTrip.value = client.roundTrip;
  };
  client.onRoundTrip(showRoundTrip);
  watch(visibility, showRoundTrip);

  const isConnected = computed(() => state.value.status === 'connected');
  const isSuperseded = computed(
    () => state.value.status === 'closed' && state.value.error?.reason === 'superseded',
  );

  const clients = createClientsStore(client, isConnected);
  const name = frame === undefined ? useTabName(client, clients, ownName, tabNumber) : ownName;
  watch(name, (next) => void client.rename(next));
  adoptName(client, clients, name, Date.now);
  tellPageState(client);
  if (frame === undefined) tellOwnTab(client);
  watch(publishIntervalMs, (next) => client.setPublishIntervalMs(next));

  const masterId = shallowRef('');
  // Requests the id, which changes with each start of the master.
  async function learnMasterId(): Promise<void> {
    const server = await client.call('serverConfiguration').catch(() => undefined);
    if (server !== undefined) masterId.value = server.id;
  }
  watch(isConnected, (connected) => connected && void learnMasterId(), { immediate: true });

  const master = createMasterStatusStore(client, isConnected, Date.now);
  const nameOfMaster = (id: string): string | undefined =>
    nameMasters(master.view.value?.latest.cluster?.masters ?? []).find(
      (named) => named.master.id === id,
    )?.label;

  function connect(): void {
    if (state.value.status === 'reconnecting') client.retryNow();
    // The result is in `state`, which every page shows.
    else client.connect().catch(() => undefined);
  }

  async function forgetIdentity(): Promise<void> {
    await client.close();
    sessionStorage.removeItem(identityKey);
    location.reload();
  }

  return {
    client,
    state,
    isConnected,
    isSuperseded,
    roundTrip,
    name,
    mark: createOwnMark(client, localStorage),
    publishIntervalMs,
    master,
    masterId,
    clients,
    reports: createClientReportsStore(client, isConnected),
    topics: createTopicStatisticsStore(client, isConnected, Date.now),
    sessions: createSessionsStore(client, isConnected),
    nodes: createNodesStore(client, isConnected, nameOfMaster),
    connect,
    leave: () => client.leave(),
    forgetIdentity,
  };
}
