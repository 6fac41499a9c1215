import { SERVICES, type RequestMember, type ServiceInfo } from '@ubii/proto';
import type { LimitName, Limits } from '../limits/index.ts';

/** Limits for the body of a request. */
export interface BodyLimits {
  readonly bytes: number;
  /** The limit that `bytes` comes from. */
  readonly bytesLimit: LimitName;
  readonly values: number;
  /** The limit that `values` comes from. */
  readonly valuesLimit: LimitName;
}

/** A payload with a limit in encoded bytes may have so much more as JSON: names of members, escapes, base64. */
const JSON_FACTOR = 1.5;

/** Limits of large payloads; others have the ordinary limit. */
const LARGE: { readonly [M in RequestMember]?: LimitName } = {
  session: 'sessionBytes',
  sessionList: 'sessionBytes',
  processingModule: 'sessionBytes',
  processingModuleList: 'sessionBytes',
  client: 'registrationBytesPerClient',
  device: 'registrationBytesPerClient',
  topicSubscription: 'subscriptionBodyBytes',
};

/** The limits on the body of a request to a service [SV-42]. */
export function bodyLimitsOf(limits: Limits, { request }: ServiceInfo): BodyLimits {
  const large = request === undefined ? undefined : LARGE[request];
  if (large === undefined) {
    return {
      bytes: limits.serviceBodyBytes,
      bytesLimit: 'serviceBodyBytes',
      values: limits.serviceValues,
      valuesLimit: 'serviceValues',
    };
  }
  const factor = large === 'subscriptionBodyBytes' ? 1 : JSON_FACTOR;
  return {
    bytes: Math.max(limits.serviceBodyBytes, Math.floor(limits[large] * factor)),
    bytesLimit: large,
    values: Math.max(limits.serviceValues, limits.largeServiceValues),
    valuesLimit: 'largeServiceValues',
  };
}

/** Found once for the limits of a master, not for each request. */
const largestKnown = new WeakMap<Limits, BodyLimits>();

/** The limits on the body of a request whose service is not known yet: those of the largest. */
export function largestBodyLimits(limits: Limits): BodyLimits {
  let largest = largestKnown.get(limits);
  if (largest === undefined) {
    largest = Object.values(SERVICES)
      .map((service) => bodyLimitsOf(limits, service))
      .reduce((most, each) => (each.bytes > most.bytes ? each : most));
    largestKnown.set(limits, largest);
  }
  return largest;
}
