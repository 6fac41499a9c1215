import { identifyTopic, ServiceError, type ClientSubscription } from '@ubii/proto';
import type { ShallowRef } from 'vue';
import { useAttempt } from '../../connection/useAttempt.ts';
import { useRole } from '../../connection/useRole.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { usePatterns, type Patterns } from '../../patterns/usePatterns.ts';
import type { ClientView } from '../model/client-view.ts';

/** Actions on clients. Each resolves to whether it succeeded; otherwise `failure` has the reason. */
export interface ClientActions {
  /** Reason why the last action failed; kept until the next one. */
  readonly failure: ShallowRef<string | undefined>;
  /** Asks a client to identify its device. [EX-34] */
  identify(view: ClientView): Promise<boolean>;
  rename(view: ClientView, name: string): Promise<boolean>;
  /** @param rate records per second; 0 lifts the throttle */
  throttle(view: ClientView, rate: number, reason: string): Promise<boolean>;
  disconnect(view: ClientView, reason: string): Promise<boolean>;
}

const ADMIN_HOW = 'The dialog “This browser” explains how to become an admin.';

export function useClientActions(): ClientActions {
  const { client, name, reports } = useConnection();
  const { isNoAdmin } = useRole();
  const toasts = useToasts();
  const patterns = usePatterns();
  const { problem: failure, attempt } = useAttempt({
    sentenceOf: (cause) =>
      isNoAdmin.value && cause instanceof ServiceError
        ? `${cause.message} ${ADMIN_HOW}`
        : cause.message,
  });

  /** @param act resolves to the sentence for the toast */
  async function done(act: () => Promise<string>): Promise<boolean> {
    const sentence = await attempt(act);
    if (sentence === undefined) return false;
    toasts.show(sentence);
    void reports.refresh();
    return true;
  }

  return {
    failure,
    identify: ({ client: { id }, label }) =>
      done(async () => {
        const topic = identifyTopic(id);
        const report = await client.call('clientReport', { clientIds: [id], subscriptions: true });
        // The value stays on the topic: a client without a connection would show it much later.
        const [activity] = report.clients;
        if (activity?.connected !== true) return `${label} is not connected.`;
        client.publish(topic, 'string', name.value, { immediate: true });
        const listens = await isHeard(topic, activity.subscriptions, patterns);
        return listens
          ? `Asked ${label} to identify itself.`
          : `${label} does not support identification.`;
      }),
    rename: ({ client: { id }, label, isSelf }, next) =>
      done(async () => {
        if (isSelf) name.value = next.trim();
        else await client.call('clientRename', { targetId: id, name: next.trim() });
        return `Renamed ${label} to ${next.trim()}.`;
      }),
    throttle: ({ client: { id }, label }, recordsPerSecond, reason) =>
      done(async () => {
        await client.call('clientThrottle', { targetId: id, recordsPerSecond, reason });
        return recordsPerSecond === 0
          ? `Throttle removed from ${label}.`
          : `Throttled ${label} to ${recordsPerSecond} records per second.`;
      }),
    disconnect: ({ client: { id }, label }, reason) =>
      done(async () => {
        await client.call('clientDisconnect', { targetId: id, reason });
        return `Disconnected ${label}.`;
      }),
  };
}

/** True when one of the subscriptions matches a topic. Regular expressions of clients are matched as on the master. */
async function isHeard(
  wanted: string,
  subscriptions: readonly ClientSubscription[],
  patterns: Patterns,
): Promise<boolean> {
  if (subscriptions.some(({ topic, pattern }) => pattern === '' && topic === wanted)) return true;
  const expressions = subscriptions.filter(({ pattern }) => pattern !== '');
  if (expressions.length === 0) return false;
  const compiler = await patterns.load().catch(() => undefined);
  return expressions.some(({ pattern }) => {
    try {
      return compiler?.compile(pattern).test(wanted) === true;
    } catch {
      return false; // Refused here, or too slow: unknown.
    }
  });
}
