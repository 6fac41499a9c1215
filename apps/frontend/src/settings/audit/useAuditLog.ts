import type { AuditEntry } from '@ubii/proto';
import { ref, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useRole } from '../../connection/useRole.ts';
import { useServiceReply, type ServiceAnswer } from '../useServiceReply.ts';

const INTERVAL_MS = 3_000;
const PAGE = 100;

/** What admins and participants did, the newest first. */
export interface LiveAudit extends Pick<ServiceAnswer<unknown>, 'problem'> {
  /** `undefined` until the master has answered. */
  readonly entries: Readonly<ShallowRef<readonly AuditEntry[] | undefined>>;
  /** There are older ones that fit. */
  readonly hasMore: Readonly<Ref<boolean>>;
  /** Asks for more of them from now on. */
  showMore(): void;
}

/** Asks for entries that fit while the calling component lives and the page is seen. */
export function useAuditLog(search: Ref<string>, service: () => string): LiveAudit {
  const { client } = useConnection();
  const { isNoAdmin } = useRole();
  const entries = shallowRef<readonly AuditEntry[]>();
  const hasMore = ref(false);
  const count = ref(PAGE);
  const ask = () =>
    client.call('auditLog', { count: count.value, text: search.value, service: service() });
  const { reply, problem } = useServiceReply(ask, INTERVAL_MS, () => !isNoAdmin.value);
  watch(reply, (log) => {
    entries.value = log?.entries;
    hasMore.value = log?.more ?? false;
  });
  // What is typed counts at once. The next poll puts right what came in another order.
  watch([search, service, count], () => {
    if (isNoAdmin.value) return;
    ask().then(
      (log) => {
        entries.value = log.entries;
        hasMore.value = log.more;
      },
      () => undefined, // the poll says why
    );
  });
  return {
    entries,
    hasMore,
    problem,
    showMore: () => (count.value = Math.min(500, count.value + PAGE)),
  };
}
