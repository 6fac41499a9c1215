import { LogLevel } from '@ubii/proto';
import { computed, ref, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useRole } from '../../connection/useRole.ts';
import { useServiceReply } from '../useServiceReply.ts';
import { addTail, EMPTY_LOG, type KeptLog } from './log-lines.ts';

const INTERVAL_MS = 1000;

/** Newest lines of the master's log. */
export interface LiveLog {
  readonly kept: Readonly<ShallowRef<KeptLog>>;
  /** True after the first reply. */
  readonly hasAnswer: ComputedRef<boolean>;
  readonly problem: ComputedRef<string | undefined>;
  /** Pauses the display; the master continues logging. */
  readonly isPaused: Ref<boolean>;
  clear(): void;
}

/** Follows the log while the calling component is mounted and the page is visible. */
export function useLogTail(): LiveLog {
  const { client } = useConnection();
  const { isNoAdmin } = useRole();
  const kept = shallowRef<KeptLog>(EMPTY_LOG);
  const isPaused = ref(false);
  const { reply, problem } = useServiceReply(
    async () =>
      isPaused.value
        ? undefined
        : client.call('logTail', { cursor: kept.value.cursor, level: LogLevel.LOG_DEBUG }),
    INTERVAL_MS,
    () => !isNoAdmin.value,
  );
  watch(reply, (tail) => {
    if (tail && !isPaused.value) kept.value = addTail(kept.value, tail);
  });
  const hasAnswer = computed(() => kept.value !== EMPTY_LOG);
  return {
    kept,
    hasAnswer,
    problem,
    isPaused,
    clear: () => (kept.value = { ...kept.value, lines: [], missed: 0 }),
  };
}
