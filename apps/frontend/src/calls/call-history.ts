import { ServiceError, SERVICES, toJson, type JsonObject, type ServiceName } from '@ubii/proto';
import type { MessageType } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';

/** Result of a call. */
export type CallOutcome =
  | { readonly kind: 'reply'; readonly json: JsonObject }
  | { readonly kind: 'error'; readonly code: string; readonly sentence: string };

/** A call of this visit. */
export interface CallRecord {
  readonly id: number;
  readonly service: ServiceName;
  /** Undefined for a call without a request. */
  readonly request: JsonObject | undefined;
  readonly atMs: number;
  readonly tookMs: number;
  readonly outcome: CallOutcome;
}

/** Most calls kept; older ones are dropped. */
export const MAX_CALLS = 30;

/** Calls of this visit, newest first. */
export interface CallHistory {
  readonly calls: Readonly<ShallowRef<readonly CallRecord[]>>;
  add(call: Omit<CallRecord, 'id'>): CallRecord;
  clear(): void;
}

export function createCallHistory(): CallHistory {
  const calls = shallowRef<readonly CallRecord[]>([]);
  let lastId = 0;
  return {
    calls,
    add(call) {
      const added = { ...call, id: ++lastId };
      calls.value = [added, ...calls.value].slice(0, MAX_CALLS);
      return added;
    },
    clear: () => (calls.value = []),
  };
}

/** Result with the reply of a service, as JSON. */
export function replyOutcome(service: ServiceName, reply: unknown): CallOutcome {
  const type = SERVICES[service].replyFormat as MessageType;
  return { kind: 'reply', json: toJson(type, reply as never) };
}

/** Result with the reason why there was no reply. */
export function errorOutcome(error: unknown): CallOutcome {
  const sentence = error instanceof Error ? error.message : String(error);
  return { kind: 'error', code: error instanceof ServiceError ? error.code : 'no_reply', sentence };
}
