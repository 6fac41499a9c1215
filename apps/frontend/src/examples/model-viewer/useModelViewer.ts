import { type Client, ClientState, type Quaternion } from '@ubii/proto';
import { computed, onScopeDispose, shallowRef, watch } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { SMART_DEVICE } from '../../devices/smart-device/components.ts';
import { useDevice } from '../../devices/useDevice.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import { chooseSource, keyOf, type TurnSource } from './choose-source.ts';
import { isSmoothingOf, smoothingSession } from './smoothing-session.ts';
import { modelTurn, STRAIGHT, turnAbout, turnBy, unitTurn } from './turns.ts';
import {
  clientOfTopic,
  PHONE_TURNS_GLOB,
  smoothedTopic,
  TURN_COMPONENT,
  turnTopic,
  VIEWER_DEVICE,
} from './viewer-topics.ts';

/** Provides the rotation of the model and its sources, while the calling scope lives. */
export function useModelViewer() {
  const { client, clients, isConnected } = useConnection();

  const sources = computed<readonly TurnSource[]>(() =>
    (clients.list.value ?? [])
      .filter(({ state }) => state !== ClientState.UNAVAILABLE)
      .flatMap((one) => sourcesOf(one, client.id))
      .sort((a, b) => Number(b.isPhone) - Number(a.isPhone) || a.name.localeCompare(b.name)),
  );
  /** Clients of phones that publish their orientation, the newest last. */
  const { byTopic: phoneTurns } = useTopic(
    { glob: PHONE_TURNS_GLOB },
    { format: 'quaternion', maxRateHz: 2 },
  );
  const moving = computed(() => Array.from(phoneTurns.value.keys(), clientOfTopic));

  /** The source that the user chose, while its device exists. */
  const wanted = shallowRef<string>();
  const source = computed(() => chooseSource(sources.value, wanted.value, moving.value));
  /** Rotation by hand is drawn at once, without a round trip to the master. */
  const isOwn = computed(() => source.value === undefined || isStandIn(source.value));

  const smoothing = useOwnedSession({
    life: 'shared',
    isOwn: (session) => source.value !== undefined && isSmoothingOf(session, source.value.clientId),
    spec: () => {
      if (!source.value) throw new Error('The model has no source of rotation.');
      const { clientId, name, isPhone } = source.value;
      return smoothingSession(clientId, name, turnTopic(clientId, isPhone));
    },
  });
  const isSmooth = computed(() => smoothing.isRunning.value && !isOwn.value);

  const device = useDevice({
    name: VIEWER_DEVICE,
    tags: ['example'],
    components: [
      {
        name: TURN_COMPONENT,
        format: 'quaternion',
        tags: ['orientation'],
        description: 'Rotation with mouse, fingers or keys in the model viewer.',
      },
    ] as const,
  });

  /** The orientation from the device; undefined before the first record. */
  const told = shallowRef<Quaternion>();
  /** The orientation that the user defined as straight ahead. */
  const zero = shallowRef<Quaternion>();
  /** The rotation made in this browser. */
  const made = shallowRef<Quaternion>(START);

  const topic = computed(() => {
    if (source.value === undefined || isOwn.value) return undefined;
    const { clientId, isPhone } = source.value;
    return isSmooth.value ? smoothedTopic(clientId) : turnTopic(clientId, isPhone);
  });
  watch(
    () => source.value && keyOf(source.value),
    () => {
      told.value = undefined;
      zero.value = undefined;
    },
  );
  const { newest } = useTopic(topic, { format: 'quaternion' });
  watch(newest, (record) => (told.value = (record && unitTurn(record.value)) ?? told.value));

  const turn = computed(() => {
    if (isOwn.value) return made.value;
    if (!told.value) return START;
    // Another browser publishes an orientation on the screen.
    if (!source.value?.isPhone && !zero.value) return told.value;
    return modelTurn(told.value, zero.value);
  });

  function make(next: Quaternion): void {
    made.value = unitTurn(next) ?? made.value;
    device.publish(TURN_COMPONENT, made.value);
  }

  // Remove a session that this page started, because no page would stop it.
  let startedFor: string | undefined;
  async function setSmooth(on: boolean): Promise<void> {
    if (!on) return smoothing.stop();
    await smoothing.start();
    startedFor = smoothing.session.value?.id;
  }
  onScopeDispose(() => {
    if (startedFor === undefined) return;
    // It may be removed already.
    client.call('sessionRuntimeRemove', { id: startedFor }).catch(() => undefined);
  });

  return {
    isConnected,
    sources,
    source,
    /** Names of phones that publish no orientation. */
    silent: computed(() =>
      sources.value
        .filter(({ isPhone, clientId }) => isPhone && !moving.value.includes(clientId))
        .map(({ name }) => name),
    ),
    isOwn,
    turn,
    /** True when there is an orientation. */
    hasTurn: computed(() => isOwn.value || told.value !== undefined),
    hasZero: computed(() => zero.value !== undefined),
    smoothing,
    isSmooth,
    setSmooth,
    choose(key: string): void {
      wanted.value = key;
    },
    /** Defines the current orientation as straight ahead; a second call clears it. */
    calibrate(): void {
      if (isOwn.value) make(made.value === STRAIGHT ? START : STRAIGHT);
      else zero.value = zero.value ? undefined : told.value;
    },
    /** Rotates the model by hand, radians about the screen's y and x axis. */
    turnByHand(aboutY: number, aboutX: number): void {
      if (!isOwn.value) {
        const standIn = sources.value.find((one) => isStandIn(one));
        if (!standIn) return;
        // Continue from the current rotation.
        made.value = turn.value;
        wanted.value = keyOf(standIn);
      }
      const step = turnBy(turnAbout([1, 0, 0], aboutX), turnAbout([0, 1, 0], aboutY));
      make(turnBy(step, made.value));
    },
  };

  function isStandIn(one: TurnSource): boolean {
    return one.isOwn && !one.isPhone;
  }
}

/** Initial rotation: seen from above and from the side. */
const START = turnBy(turnAbout([1, 0, 0], -1.1), turnAbout([0, 0, 1], -0.6));

function sourcesOf({ id, name, devices }: Client, ownId: string): TurnSource[] {
  const has = (device: string): boolean => devices.some((one) => one.name === device);
  const source = { clientId: id, name, isOwn: id === ownId };
  return [
    ...(has(SMART_DEVICE) ? [{ ...source, isPhone: true }] : []),
    ...(has(VIEWER_DEVICE) ? [{ ...source, isPhone: false }] : []),
  ];
}
