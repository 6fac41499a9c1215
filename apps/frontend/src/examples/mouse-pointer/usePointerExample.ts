import type { RegisteredDevice } from '@ubii/client-web';
import { type Client, ClientState } from '@ubii/proto';
import { useIntervalFn, useLocalStorage } from '@vueuse/core';
import * as v from 'valibot';
import { onScopeDispose, readonly, shallowRef, watch } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import {
  exampleTopic,
  MIRROR_X_COMPONENT,
  MIRROR_Y_COMPONENT,
  MIRRORED_COMPONENT,
  POINTER_COMPONENT,
  POINTER_DEVICE,
  POINTER_GLOB,
} from '../../devices/pointer-topic.ts';
import { storedAs } from '../../json/read-stored.ts';
import { finite, flag } from '../../json/schemas.ts';
import { type EchoLatency, EchoLatencyWindow } from './echo-latency.ts';
import { type Pointer, type PointerClient, Pointers } from './pointers.ts';

const COMPONENTS = [
  {
    name: POINTER_COMPONENT,
    format: 'vector2',
    tags: ['pointer'],
    description: 'Pointer on the pad, 0 to 1 on both axes, origin top left.',
  },
  {
    name: MIRROR_X_COMPONENT,
    format: 'bool',
    tags: ['switch'],
    description: 'True when the session mirrors the pointer in x.',
  },
  {
    name: MIRROR_Y_COMPONENT,
    format: 'bool',
    tags: ['switch'],
    description: 'True when the session mirrors the pointer in y.',
  },
] as const;

/** Update interval of the readouts. */
const READOUT_INTERVAL_MS = 250;
const SPARKLINE_POINTS = 120;

const SETTINGS_KEY = 'ubii.examples.mouse-pointer';
const SETTINGS = v.object({
  hideCursor: flag,
  hideIndicator: flag,
  immediate: flag,
  intervalMs: v.fallback(finite, 15),
});
const MIRROR = v.object({ x: v.fallback(v.boolean(), true), y: flag });

/** Values of the readouts. */
export interface PointerReadouts {
  readonly latency: EchoLatency | undefined;
  /** Round trip through the session's module. */
  readonly through: EchoLatency | undefined;
  /** Newest round trips, oldest first, milliseconds. */
  readonly recentMs: readonly number[];
  readonly publishedPerSecond: number;
  readonly receivedPerSecond: number;
}

/**
 * Publishes this browser's pointer and subscribes to the pointers of all clients, while the calling scope
 * lives. Read positions with `position()` once per frame; only the list of clients is reactive.
 */
export function usePointerExample() {
  const { client, clients, isConnected, publishIntervalMs } = useConnection();
  const pointers = new Pointers();
  const latency = new EchoLatencyWindow();
  /** Round trip through the session. The module keeps the timestamp of the pointer, but not its position. */
  const through = new EchoLatencyWindow();
  const people = shallowRef<readonly Pointer[]>([]);
  const readouts = shallowRef<PointerReadouts>({
    latency: undefined,
    through: undefined,
    recentMs: [],
    publishedPerSecond: 0,
    receivedPerSecond: 0,
  });
  const settings = useLocalStorage(SETTINGS_KEY, v.parse(SETTINGS, {}), {
    serializer: storedAs(SETTINGS, {}),
  });
  const mirror = useLocalStorage(`${SETTINGS_KEY}.mirror`, v.parse(MIRROR, {}), {
    serializer: storedAs(MIRROR, {}),
  });

  let device: RegisteredDevice<typeof COMPONENTS> | undefined;
  let ended = false;
  void client
    .registerDevice({ name: POINTER_DEVICE, tags: ['example'], components: COMPONENTS })
    .then((registered) => {
      if (ended) return registered.close();
      device = registered;
      publishMirror();
      return undefined;
    })
    // Rejects only when the client is closed, which the shell shows.
    .catch(() => undefined);

  /** Publishes the switches. The master retains the values for sessions that start later. */
  function publishMirror(): void {
    device?.component(MIRROR_X_COMPONENT).publish(mirror.value.x);
    device?.component(MIRROR_Y_COMPONENT).publish(mirror.value.y);
  }
  watch(mirror, publishMirror, { deep: true });
  watch(isConnected, (connected) => connected && publishMirror());

  /** The newest position from the session. */
  let mirrored: { readonly x: number; readonly y: number } | undefined;
  useTopic(() => (isConnected.value ? exampleTopic(client.id, MIRRORED_COMPONENT) : undefined), {
    format: 'vector2',
    keep: 0,
    onRecord({ value, timestampMs }) {
      mirrored = value;
      through.returned({ timestampMs, x: 0, y: 0 }, performance.now());
    },
  });

  let published = 0;
  let received = 0;
  useTopic(
    { glob: POINTER_GLOB },
    {
      format: 'vector2',
      keep: 0,
      onRecord({ topic, value, timestampMs }) {
        received++;
        const clientId = pointers.move(topic, value);
        if (clientId === client.id) latency.returned({ timestampMs, ...value }, performance.now());
      },
    },
  );

  watch(
    clients.list,
    (list) => {
      pointers.setClients((list ?? []).filter(isHere).map(toPointerClient));
      people.value = pointers.list();
    },
    { immediate: true },
  );
  watch(isConnected, () => {
    latency.clear();
    through.clear();
  });
  watch(
    () => settings.value.intervalMs,
    (intervalMs) => client.setPublishIntervalMs(intervalMs),
    { immediate: true },
  );

  let readAtMs = performance.now();
  useIntervalFn(() => {
    const nowMs = performance.now();
    const perSecond = 1000 / (nowMs - readAtMs);
    readouts.value = {
      latency: latency.summary(),
      through: through.summary(),
      recentMs: latency.recent(SPARKLINE_POINTS),
      publishedPerSecond: published * perSecond,
      receivedPerSecond: received * perSecond,
    };
    readAtMs = nowMs;
    published = 0;
    received = 0;
  }, READOUT_INTERVAL_MS);

  onScopeDispose(() => {
    ended = true;
    client.setPublishIntervalMs(publishIntervalMs.value);
    void device?.close();
  });

  return {
    /** All clients on the example, including this browser. */
    people: readonly(people),
    settings,
    /** Axes that the session mirrors; published as topics of this client. */
    mirror,
    /** Returns the newest position of this browser's pointer from the session. */
    mirrored: () => mirrored,
    readouts: readonly(readouts),
    /** Returns the position of a client's pointer, as received from the master. */
    position: (clientId: string) => pointers.position(clientId),
    /** Publishes a position; both axes 0 to 1, origin top left. Does nothing before the device is registered. */
    publish(x: number, y: number) {
      if (device === undefined) return;
      const timestampMs = Date.now();
      latency.sent({ timestampMs, x, y }, performance.now());
      through.sent({ timestampMs, x: 0, y: 0 }, performance.now());
      published++;
      device
        .component(POINTER_COMPONENT)
        .publish({ x, y }, { timestampMs, immediate: settings.value.immediate });
    },
  };
}

/** False for a client that has left: the master keeps it in the list for some time. [CL-13] */
function isHere({ state }: Client): boolean {
  return state !== ClientState.UNAVAILABLE;
}

function toPointerClient({ id, name, state, devices }: Client): PointerClient {
  return {
    id,
    name,
    active: state === ClientState.ACTIVE,
    deviceNames: devices.map((device) => device.name),
  };
}
