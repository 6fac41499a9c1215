import type { RegisteredDevice } from '@ubii/client-web';
import { type Client, ClientState } from '@ubii/proto';
import { useIntervalFn, useLocalStorage } from '@vueuse/core';
import { onScopeDispose, readonly, shallowRef, watch } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { type EchoLatency, EchoLatencyWindow } from './echo-latency.ts';
import {
  exampleTopic,
  MIRROR_X_COMPONENT,
  MIRROR_Y_COMPONENT,
  MIRRORED_COMPONENT,
  POINTER_COMPONENT,
  POINTER_DEVICE,
  POINTER_GLOB,
} from './pointer-topic.ts';
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
    description: 'Whether the session mirrors the pointer from left to right.',
  },
  {
    name: MIRROR_Y_COMPONENT,
    format: 'bool',
    tags: ['switch'],
    description: 'Whether the session mirrors the pointer from top to bottom.',
  },
] as const;

/** How often the readouts are computed, not how often data flows. */
const READOUT_INTERVAL_MS = 250;
const SPARKLINE_POINTS = 120;

/** What the readouts show of the last moments. */
export interface PointerReadouts {
  readonly latency: EchoLatency | undefined;
  /** To the session's module and back. */
  readonly through: EchoLatency | undefined;
  /** Newest round trips, oldest first, milliseconds. */
  readonly recentMs: readonly number[];
  readonly publishedPerSecond: number;
  readonly receivedPerSecond: number;
}

/**
 * Publishes this browser's pointer and follows everybody's, while the calling scope lives.
 * Positions are read with `position()` once per frame; only who is here is reactive.
 */
export function usePointerExample() {
  const { client, clients, isConnected, publishIntervalMs } = useConnection();
  const pointers = new Pointers();
  const latency = new EchoLatencyWindow();
  /** Through the session: the module keeps the time of the pointer, not its place. */
  const through = new EchoLatencyWindow();
  const people = shallowRef<readonly Pointer[]>([]);
  const readouts = shallowRef<PointerReadouts>({
    latency: undefined,
    through: undefined,
    recentMs: [],
    publishedPerSecond: 0,
    receivedPerSecond: 0,
  });
  const settings = useLocalStorage('ubii.examples.mouse-pointer', {
    hideCursor: false,
    hideIndicator: false,
    immediate: false,
    intervalMs: 15,
  });
  const mirror = useLocalStorage('ubii.examples.mouse-pointer.mirror', { x: true, y: false });

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
    // Only when the client is closed for good, which the shell shows.
    .catch(() => undefined);

  /** The newest stays on its topic, so that a session that comes later has it. */
  function publishMirror(): void {
    device?.component(MIRROR_X_COMPONENT).publish(mirror.value.x);
    device?.component(MIRROR_Y_COMPONENT).publish(mirror.value.y);
  }
  watch(mirror, publishMirror, { deep: true });
  watch(isConnected, (connected) => connected && publishMirror());

  /** Where the session put the pointer last. */
  let mirrored: { readonly x: number; readonly y: number } | undefined;
  watch(
    isConnected,
    (connected, _before, onCleanup) => {
      if (!connected) return;
      const returned = client
        .subscribe(exampleTopic(client.id, MIRRORED_COMPONENT), { format: 'vector2' })
        .onRecord(({ value, timestampMs }) => {
          mirrored = value;
          through.returned({ timestampMs, x: 0, y: 0 }, performance.now());
        });
      onCleanup(() => void returned.close());
    },
    { immediate: true },
  );

  let published = 0;
  let received = 0;
  const subscription = client
    .subscribe({ glob: POINTER_GLOB }, { format: 'vector2' })
    .onRecord(({ topic, value, timestampMs }) => {
      received++;
      const clientId = pointers.move(topic, value);
      if (clientId === client.id) latency.returned({ timestampMs, ...value }, performance.now());
    });

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
    void subscription.close();
    void device?.close();
  });

  return {
    /** Everybody on the example, this browser included. */
    people: readonly(people),
    settings,
    /** In which axes the session mirrors; published as topics of this client. */
    mirror,
    /** Where the session put this browser's pointer last. */
    mirrored: () => mirrored,
    readouts: readonly(readouts),
    /** Where the client's pointer is, as it came back from the master. */
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

/** The master remembers a client for a while after it went; its topics have ended by then. [CL-13] */
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
