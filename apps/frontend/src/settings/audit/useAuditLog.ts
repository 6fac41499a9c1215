import type { AuditEntry } from '@ubii/proto';
import { ref, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useRole } from '../../connection/useRole.ts';
import { useServiceReply, type ServiceAnswer } from '../useServiceReply.ts';

const INTERVAL_MS = 3_000;
const PAGE = 100;

/** Actions of admins and participants, newest first. */
export interface LiveAudit extends Pick<ServiceAnswer<unknown>, 'problem'> {
  /** `undefined` until the first reply. */
  readonly entries: Readonly<ShallowRef<readonly AuditEntry[] | undefined>>;
  /** True when there are older matching entries. */
  readonly hasMore: Readonly<Ref<boolean>>;
  /** Requests more entries from now on. */
  showMore(): void;
}

/** Requests matching entries while the calling component is mounted and the page is visible. */
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
  // Request at once while typing. The next poll corrects replies that arrived out of order.
  watch([search, service, count], () => {
    if (isNoAdmin.value) return;
    ask().then(
      (log) => {
        entries.value = log.entries;
        hasMore.value = log.more;
      },
      () => undefined, // The poll reports the reason.
    );
  });
  return {
    entries,
    hasMore,
    problem,
    showMore: () => (count.value = Math.min(500, count.value + PAGE)),
  };
}
