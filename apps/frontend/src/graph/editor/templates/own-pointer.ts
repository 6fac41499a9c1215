import type { RegisteredDevice } from '@ubii/client-web';
import { useEventListener } from '@vueuse/core';
import { computed, shallowRef, watch, type ComputedRef, type Ref } from 'vue';
import { useConnection } from '../../../connection/useConnection.ts';
import { exampleTopic, POINTER_COMPONENT, POINTER_DEVICE } from '../../../devices/pointer-topic.ts';
import { whileUsed } from './while-used.ts';

const COMPONENTS = [
  {
    name: POINTER_COMPONENT,
    format: 'vector2',
    tags: ['pointer'],
    description: 'Pointer in the window, 0 to 1 on both axes, origin top left.',
  },
] as const;

/** This browser's pointer as a topic, so that users can try a session without a second device. */
export interface OwnPointer {
  readonly topic: ComputedRef<string>;
  /** Set to start or stop publishing. */
  readonly isOn: Ref<boolean>;
}

/**
 * Shared by all parts of the editor, while at least one is mounted. Uses the device of the mouse-pointer example, so
 * that sessions for one work with the other.
 */
export const useOwnPointer = whileUsed((): OwnPointer => {
  const { client, isConnected } = useConnection();
  const isOn = shallowRef(false);
  const topic = computed(() => {
    void isConnected.value;
    return exampleTopic(client.id, POINTER_COMPONENT);
  });
  let device: RegisteredDevice<typeof COMPONENTS> | undefined;

  watch(isOn, async (on, _before, onCleanup) => {
    if (!on) return;
    let isOver = false;
    onCleanup(() => {
      isOver = true;
      void device?.close();
      device = undefined;
    });
    try {
      const registered = await client.registerDevice({
        name: POINTER_DEVICE,
        tags: ['example'],
        components: COMPONENTS,
      });
      if (isOver) return void registered.close();
      device = registered;
      publish(0.5, 0.5);
    } catch {
      // Fails only when the client was closed permanently, which the shell shows.
      isOn.value = false;
    }
  });

  function publish(x: number, y: number): void {
    device?.component(POINTER_COMPONENT).publish({ x, y });
  }
  useEventListener(
    window,
    ['pointermove', 'pointerdown'],
    ({ clientX, clientY, isPrimary }: PointerEvent) => {
      if (isPrimary && device) publish(clientX / innerWidth, clientY / innerHeight);
    },
    { passive: true, capture: true },
  );
  return { topic, isOn };
});
