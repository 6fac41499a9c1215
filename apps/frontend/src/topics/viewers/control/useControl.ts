import type { DataFormat, TopicRecord } from '@ubii/proto';
import { useTimeoutFn } from '@vueuse/core';
import { computed, onScopeDispose, shallowRef, type ComputedRef, type ShallowRef } from 'vue';
import { KEPT_MINUTES } from '../../../connection/kept-minutes.ts';
import { perFrame } from '../../../connection/per-frame.ts';
import { useConnection } from '../../../connection/useConnection.ts';
import { useRole } from '../../../connection/useRole.ts';
import type { ViewerSettings } from '../topic-viewer.ts';
import { controlFormat } from './control-settings.ts';

/** Time for which a control shows its own value, until that comes back from the master, milliseconds. */
const OWN_MS = 500;

/** Where a control publishes. */
export interface ControlPlace {
  readonly topic: string;
  readonly record: TopicRecord | undefined;
  readonly settings: ViewerSettings;
}

/** A control of a topic: shows its value, also one that others published, and publishes. */
export interface Control {
  readonly format: ComputedRef<DataFormat>;
  /** Value of the topic; `undefined` before the first. */
  readonly value: ComputedRef<unknown>;
  /** Why it cannot publish, one sentence. */
  readonly reason: ComputedRef<string | undefined>;
  /** Why the master refused the last value. */
  readonly error: Readonly<ShallowRef<string | undefined>>;
  /** Publishes. @param isKept whether the value stays after this tab was closed, for a while */
  send(value: unknown, isKept: boolean): void;
  /** Publishes the newest value of each frame, and keeps it. */
  sendLive(value: unknown): void;
}

/** @param formats data formats that the control sends, the default first */
export function useControl(place: () => ControlPlace, formats: readonly DataFormat[]): Control {
  const { client, isConnected } = useConnection();
  const { role } = useRole();
  const format = computed(() => {
    const { record, settings } = place();
    return formats.find((one) => one === record?.format) ?? controlFormat(settings, formats);
  });
  const own = shallowRef<{ readonly value: unknown }>();
  const { start: forgetLater } = useTimeoutFn(() => (own.value = undefined), OWN_MS, {
    immediate: false,
  });
  const error = shallowRef<string>();
  onScopeDispose(
    // The client has one channel for errors; they name the topic.
    client.onError(({ message }) => {
      if (message.includes(place().topic)) error.value = message;
    }),
  );
  const reason = computed(() => {
    if (!isConnected.value) return 'Not connected to the master.';
    return role.value === 'viewer' ? 'You joined as a viewer, which does not publish.' : undefined;
  });

  function show(value: unknown): boolean {
    if (reason.value !== undefined) return false;
    own.value = { value };
    forgetLater();
    return true;
  }
  function publish(value: unknown, isKept: boolean): void {
    error.value = undefined;
    try {
      const options = isKept ? { keepSeconds: KEPT_MINUTES * 60 } : {};
      client.publish(place().topic, format.value, value as never, options);
    } catch (cause) {
      error.value = cause instanceof Error ? cause.message : String(cause);
    }
  }
  let waiting: { readonly value: unknown } | undefined;
  function publishWaiting(): void {
    if (waiting) publish(waiting.value, true);
    waiting = undefined;
  }
  const publishSoon = perFrame(publishWaiting);
  // The last value of a drag, when the panel goes within the frame.
  onScopeDispose(publishWaiting);

  return {
    format,
    value: computed(() => (own.value ?? place().record)?.value),
    reason,
    error,
    send(value, isKept) {
      if (!show(value)) return;
      publishWaiting();
      publish(value, isKept);
    },
    sendLive(value) {
      if (!show(value)) return;
      waiting = { value };
      publishSoon();
    },
  };
}
