import { wireRole } from '../access/roles.ts';
import {
  ClientActivityAddressKind,
  type ClientActivity,
  type ClientClock,
  type ClientReportRequest,
  type ClientSubscription,
  type ClientThrottle,
  type Init,
  type ClientReport,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { Core } from '../areas/core.ts';
import type { AddressKind } from '../ports/address-kind.ts';
import type { ClientSubscriber } from '../topics/subscriber.ts';
import type { Client } from '../clients/client.ts';
import type { Throttle } from '../counters/throttle.ts';

/** Dependencies of client reports. */
export type ClientReportContext = Pick<Core, 'clients' | 'clock' | 'clientMeter'>;

/** Subscriptions listed of one client [EX-25]. */
const MAX_SUBSCRIPTIONS = 1_000;

const ADDRESS_KINDS: Readonly<Record<AddressKind, ClientActivity['addressKind']>> = {
  loopback: ClientActivityAddressKind.LOOPBACK,
  private: ClientActivityAddressKind.PRIVATE,
  public: ClientActivityAddressKind.PUBLIC,
};

/** Reports the activity of clients and their share of the work of the master [EX-25]. */
export function readClientReport(
  { clients, clock, clientMeter }: ClientReportContext,
  request: ClientReportRequest,
): Init<ClientReport> {
  const wanted = new Set(request.clientIds);
  const reported = [...clients.values()].filter(
    ({ id, home }) => home?.isLost !== false && (wanted.size === 0 || wanted.has(id)),
  );
  return {
    masterTimeMs: clock.nowMs(),
    measuredMs: clientMeter.seconds * 1000,
    clients: reported.map((client) => activityOf(client, clock, request.subscriptions)),
  };
}

function activityOf(
  client: Client,
  clock: Clock,
  withSubscriptions: boolean,
): Init<ClientActivity> {
  const { traffic, subscriber, socket, peer, throttle } = client;
  const { recordsIn, bytesIn, refused, rates, workShare } = traffic;
  const { outbox, topics, patterns, selections, watchers } = subscriber;
  const { addressKind, addressGroup } = peer;
  const isMeasured = client.latencyMs > 0;
  const { throttledPerSecond: _, ...perSecond } = rates;
  return {
    clientId: client.id,
    firstSeenMs: client.firstSeenMs,
    lastSeenMs: clock.nowMs() - (clock.monotonicMs() - client.lastSignMs),
    connected: socket !== undefined,
    connectedMs: socket === undefined ? 0 : client.socketOpenedMs,
    roundTripMs: client.latencyMs,
    roundTripAgeMs: isMeasured ? clock.monotonicMs() - client.latencyMeasuredMs : 0,
    recordsIn,
    bytesIn,
    recordsOut: outbox.handedRecords,
    bytesOut: outbox.handedBytes,
    ...perSecond,
    queuedRecords: outbox.waitingCount,
    queuedBytes: outbox.waitingBytes + (socket?.connection.queuedBytes ?? 0),
    dropped: outbox.drops.count,
    refused,
    protocolErrors: client.protocolErrors.count,
    topicSubscriptions: topics.size,
    patternSubscriptions: patterns.size,
    componentSubscriptions: selections.size,
    watchesEverything: watchers.size > 0,
    subscriptions: withSubscriptions ? subscriptionsOf(subscriber) : [],
    ownedTopics: client.ownedTopics.size,
    userAgent: peer.program,
    library: client.library,
    addressKind: wireAddressKind(addressKind),
    addressGroup,
    ...(throttle !== undefined && { throttle: throttleOf(throttle) }),
    workShare,
    ...(client.clock !== undefined && { clock: clockOf(client.clock, clock) }),
    role: wireRole(client.access.role), // [AC-20]
    grantId: client.access.grant?.id ?? '',
  };
}

/** Converts the kind of an address for the wire. */
export function wireAddressKind(kind: AddressKind | undefined): ClientActivityAddressKind {
  return kind === undefined ? ClientActivityAddressKind.UNKNOWN : ADDRESS_KINDS[kind];
}

function subscriptionsOf(subscriber: ClientSubscriber): Init<ClientSubscription>[] {
  const subscriptions: Init<ClientSubscription>[] = [];
  for (const subscription of eachSubscription(subscriber)) {
    if (subscriptions.push(subscription) >= MAX_SUBSCRIPTIONS) break;
  }
  return subscriptions;
}

/** Subscriptions in order of cost, highest first. */
function* eachSubscription(subscriber: ClientSubscriber): Iterable<Init<ClientSubscription>> {
  const { topics, patterns, selections } = subscriber;
  for (const { source, subscribers } of patterns) {
    yield { pattern: source, maxRateHz: subscribers.get(subscriber) ?? 0 };
  }
  for (const { profile, subscribers } of selections) {
    yield { component: profile, maxRateHz: subscribers.get(subscriber) ?? 0 };
  }
  for (const { topic, subscribers } of topics) {
    yield { topic, maxRateHz: subscribers.get(subscriber) ?? 0 };
  }
}

/** [TS-10] */
function clockOf(
  { offsetMs, errorMs, driftPpm, toldMs }: NonNullable<Client['clock']>,
  clock: Clock,
): Init<ClientClock> {
  return { offsetMs, errorMs, driftPpm, ageMs: clock.monotonicMs() - toldMs };
}

function throttleOf(throttle: Throttle): Init<ClientThrottle> {
  const { recordsPerSecond, byPolicy, byName, reason, sinceMs, dropped } = throttle;
  return { recordsPerSecond, byPolicy, byName, reason, sinceMs, dropped };
}
