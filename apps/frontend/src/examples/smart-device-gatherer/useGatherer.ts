import { type Client, ClientState } from '@ubii/proto';
import { useIntervalFn, useRafFn } from '@vueuse/core';
import { computed, shallowRef, watch } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import {
  clientOfTopic,
  DEFAULT_DISTANCE,
  DISTANCE_TOPIC,
  MOTION_GLOB,
  NEAR_GLOB,
  nearTopic,
  PROXIMITY_SESSION,
  TOUCHES_GLOB,
} from './gatherer-topics.ts';
import { Gathering, type GatheredTouch, type NearPair, type PhoneClient } from './gathering.ts';

/** Update interval of the list, milliseconds. The pad is drawn in every frame. */
const LIST_INTERVAL_MS = 150;
const LINE_POINTS = 40;
/** How long the distance outlives the page, seconds: as long as the master keeps values at most. */
const KEEP_SECONDS = 3600;

/** Row of a phone in the list. */
export interface PhoneRow extends PhoneClient {
  readonly fingers: number;
  readonly isNear: boolean;
  /** m/s²; `undefined` while the phone publishes no motion. */
  readonly motion: number | undefined;
  /** Motion of the last seconds, oldest first. */
  readonly line: readonly number[];
}

/** All phones and the shared session, while the calling scope is active. */
export function useGatherer() {
  const { client, clients, isConnected } = useConnection();
  const gathering = new Gathering();
  const phones = shallowRef<readonly PhoneRow[]>([]);
  const touches = shallowRef<readonly GatheredTouch[]>([]);
  const pairs = shallowRef<readonly NearPair[]>([]);
  const { newest: toldDistance } = useTopic(DISTANCE_TOPIC, { format: 'double' });
  const distance = computed(() => toldDistance.value?.value ?? DEFAULT_DISTANCE);
  const proximity = useOwnedSession({
    life: 'shared',
    isOwn: ({ name }) => name === PROXIMITY_SESSION,
    spec: async () => (await import('@ubii/modules')).EXAMPLE_SESSIONS['touch-proximity'],
  });
  const { isRunning } = proximity;
  /** Published for all: the session and other clients receive it. The session continues when this page is left. */
  function setDistance(next: number): void {
    client.publish(DISTANCE_TOPIC, 'double', next, { keepSeconds: KEEP_SECONDS });
  }
  /** True when the pad must be drawn. */
  let isNew = true;

  useTopic(
    { glob: TOUCHES_GLOB },
    {
      format: 'touchEventList',
      keep: 0,
      onRecord({ topic, value }) {
        gathering.touch(clientOfTopic(topic), value);
        isNew = true;
      },
    },
  );
  useTopic(
    { glob: MOTION_GLOB },
    {
      format: 'vector3',
      keep: 0,
      onRecord: ({ topic, value }) => gathering.move(clientOfTopic(topic), value),
    },
  );

  const lines = new Map<string, number[]>();
  function list(): void {
    phones.value = gathering.phones().map((phone) => {
      const motion = gathering.motionOf(phone.id);
      const line = [...(lines.get(phone.id) ?? []).slice(1 - LINE_POINTS), motion ?? 0];
      lines.set(phone.id, line);
      const fingers = touches.value.filter(({ clientId }) => clientId === phone.id).length;
      const isNear = isRunning.value && fingers > 0 && gathering.isNear(phone.id);
      return { ...phone, fingers, isNear, motion, line: motion === undefined ? [] : line };
    });
  }
  useIntervalFn(list, LIST_INTERVAL_MS);
  useRafFn(() => {
    if (!isNew) return;
    isNew = false;
    touches.value = gathering.touches();
    pairs.value = isRunning.value ? gathering.pairs(distance.value) : [];
  });

  watch(
    clients.list,
    (all) => {
      gathering.setClients((all ?? []).filter(isHere).map(toPhoneClient));
      for (const id of lines.keys()) {
        if (!gathering.phones().some((phone) => phone.id === id)) lines.delete(id);
      }
      isNew = true;
      list();
    },
    { immediate: true },
  );
  // Drop the results of a session that ended. The next one may publish before it is known to run: its topics keep the
  // newest value.
  watch(isRunning, (running) => !running && gathering.forgetNear());
  useTopic(() => (isRunning.value ? { glob: NEAR_GLOB } : undefined), {
    format: 'bool',
    keep: 0,
    onRecord({ topic, value }) {
      gathering.setNear(clientOfTopic(topic), value);
      isNew = true;
    },
  });
  watch([isRunning, distance], () => (isNew = true));

  return {
    isConnected,
    phones,
    touches,
    pairs,
    distance,
    proximity: {
      ...proximity,
      start() {
        // The graph of the session shows the distance that the page shows.
        if (toldDistance.value === undefined) setDistance(DEFAULT_DISTANCE);
        return proximity.start();
      },
    },
    setDistance,
    async stop(): Promise<void> {
      const near = gathering.phones().filter(({ id }) => gathering.isNear(id));
      await proximity.stop();
      // A stopped session does not publish false for phones that were near.
      for (const { id } of near) client.publish(nearTopic(id), 'bool', false);
    },
  };
}

/** The master keeps a client for some time after it left. [CL-13] */
function isHere({ state }: Client): boolean {
  return state !== ClientState.UNAVAILABLE;
}

function toPhoneClient({ id, name, state, devices }: Client): PhoneClient {
  return {
    id,
    name,
    active: state === ClientState.ACTIVE,
    deviceNames: devices.map((device) => device.name),
  };
}
