import { useIntervalFn } from '@vueuse/core';
import { computed, shallowRef, watch } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useRole } from '../../connection/useRole.ts';
import { useDevice } from '../../devices/useDevice.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import { PAD_COMPONENTS, PAD_DEVICE, padSession, padTopics } from './first-session.ts';
import { withPlace, type Place } from './trail.ts';

/** Window of the rates, milliseconds. */
const WINDOW_MS = 1000;

/**
 * The session of Home: publishes the pointer on its pad, and runs a session that mirrors it, while the calling scope is
 * active.
 */
export function usePadSession() {
  const { client, name, isConnected } = useConnection();
  const { role } = useRole();
  const device = useDevice({ name: PAD_DEVICE, tags: ['example'], components: PAD_COMPONENTS });
  /** Empty until the first connection. */
  const clientId = shallowRef('');
  watch(isConnected, (connected) => connected && (clientId.value = client.id), { immediate: true });
  const isViewer = computed(() => role.value === 'viewer');
  const page = useOwnedSession({
    life: 'page',
    spec: () =>
      clientId.value === '' || isViewer.value
        ? undefined
        : { place: 'master', session: padSession(clientId.value, name.value) },
  });
  const topics = computed(() => padTopics(clientId.value));

  const sent = shallowRef<readonly Place[]>([]);
  const mirrored = shallowRef<readonly Place[]>([]);
  let sentCount = 0;
  let mirroredCount = 0;
  const rates = shallowRef({ sent: 0, mirrored: 0 });
  useTopic(() => (clientId.value === '' ? undefined : topics.value.mirrored), {
    format: 'vector2',
    keep: 0,
    onRecord({ value: { x, y } }) {
      mirroredCount += 1;
      mirrored.value = withPlace(mirrored.value, { x, y });
    },
  });
  useIntervalFn(() => {
    rates.value = { sent: sentCount, mirrored: mirroredCount };
    sentCount = mirroredCount = 0;
  }, WINDOW_MS);

  return {
    topics,
    /** Positions of the pointer, oldest first. */
    sent,
    /** Positions from the session, oldest first. */
    mirrored,
    /** Records per second. */
    rates,
    isRunning: computed(() => isConnected.value && page.session.value && !page.isStarting.value),
    /** Why nothing is mirrored, one sentence. */
    trouble: computed(() => {
      if (isViewer.value) return 'Viewers can only watch, so the session was not started.';
      if (!isConnected.value) return 'Not connected. The session starts with the connection.';
      return page.trouble.value;
    }),
    publish(place: Place): void {
      sent.value = withPlace(sent.value, place);
      if (!isConnected.value) return;
      sentCount += 1;
      device.publish('pointer', place);
    },
  };
}
