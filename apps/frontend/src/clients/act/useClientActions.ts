import { ConnectionError } from '@ubii/client-web';
import { identifyTopic, ServiceError, type ClientSubscription } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
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
  const failure = shallowRef<string>();

  async function attempt(intent: () => Promise<string>): Promise<boolean> {
    failure.value = undefined;
    try {
      toasts.show(await intent());
      void reports.refresh();
      return true;
    } catch (cause) {
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
      failure.value =
        isNoAdmin.value && cause instanceof ServiceError
          ? `${cause.message} ${ADMIN_HOW}`
          : cause.message;
      return false;
    }
  }

  return {
    failure,
    identify: ({ client: { id }, label }) =>
      attempt(async () => {
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
      attempt(async () => {
        if (isSelf) name.value = next.trim();
        else await client.call('clientRename', { targetId: id, name: next.trim() });
        return `Renamed ${label} to ${next.trim()}.`;
      }),
    throttle: ({ client: { id }, label }, recordsPerSecond, reason) =>
      attempt(async () => {
        await client.call('clientThrottle', { targetId: id, recordsPerSecond, reason });
        return recordsPerSecond === 0
          ? `Throttle removed from ${label}.`
          : `Throttled ${label} to ${recordsPerSecond} records per second.`;
      }),
    disconnect: ({ client: { id }, label }, reason) =>
      attempt(async () => {
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
