import {
  SERVICES,
  type Init,
  type RequestMember,
  type ServiceInfo,
  type ServiceName,
  type ServiceReply,
  type ServiceReplyOf,
  type ServiceRequest,
  type ServiceRequestOf,
  type Success,
} from '@ubii/proto';
import type { ServiceRight } from '../access/rights-table.ts';
import type { Core } from '../areas/core.ts';
import type { ServiceCall } from './service-call.ts';

type Row<S extends ServiceName> = (typeof SERVICES)[S];

/** The payload of a request, or the members of the request where two of them can carry one. */
export type ServicePayload<S extends ServiceName> =
  Row<S>['alternativeRequest'] extends infer A extends RequestMember
    ? Pick<ServiceRequest, A | (Row<S>['request'] & RequestMember)>
    : Row<S>['requestRequired'] extends true
      ? ServiceRequestOf<S>
      : ServiceRequestOf<S> | undefined;

/** All that the master has to know of one service; topic and payloads are in `SERVICES` of `@ubii/proto`. */
export interface ServiceDefinition<S extends ServiceName, P extends keyof Core> {
  readonly roles: ServiceRight['roles'];
  /** The id of the client that asks, if the request names it. It has to be the caller [AC-22]. */
  readonly subject?: (payload: NonNullable<ServicePayload<S>>) => string;
  /** What the call is about, when that may be at another master: there it is answered [CU-28]. */
  readonly target?: (payload: NonNullable<ServicePayload<S>>) => CallTarget;
  /** True when `subject` may be another client than the caller. Default: false. */
  readonly mayNameOthers?: boolean;
  /** False when the handler itself says what the request means for the client [CL-11]. Default: true. */
  readonly isSignOfLife?: boolean;
  /** A name or id of what the call changes. With it, calls are audited [EX-90]. */
  readonly auditObject?: (core: Pick<Core, P>, payload: NonNullable<ServicePayload<S>>) => string;
  /** Adds what other masters reply to the same request to the reply [CU-29]. */
  readonly gather?: (
    reply: Init<ServiceReplyOf<S>>,
    others: readonly ServiceReplyOf<S>[],
  ) => Init<ServiceReplyOf<S>>;
  /** Returns the payload of the reply. @throws ServiceError when the request cannot be fulfilled */
  readonly handle: (
    core: Pick<Core, P>,
    payload: ServicePayload<S>,
    call: ServiceCall,
  ) => Init<ServiceReplyOf<S>> | Promise<Init<ServiceReplyOf<S>>>;
}

/** A client, a session or a module by its id; empty and absent ids mean nothing. */
export interface CallTarget {
  readonly clientId?: string;
  readonly session?: { readonly id: string; readonly name: string };
  readonly moduleId?: string;
}

/** A defined service, for those who do not know its types. */
export interface Service extends ServiceRight {
  readonly name: ServiceName;
  readonly info: ServiceInfo;
  readonly isSignOfLife: boolean;
  /** Id of the client for which the request is sent, if it names one [CL-11]. */
  subjectOf(request: ServiceRequest): string | undefined;
  /** What the call is about; the client that asks, for services that act for it. */
  targetOf(request: ServiceRequest): CallTarget;
  /** A name or id of what an audited call changes; may be empty. */
  auditObjectOf(core: Core, request: ServiceRequest): string;
  handle(core: Core, request: ServiceRequest, call: ServiceCall): Promise<Init<ServiceReply>>;
  /** Undefined: other masters have nothing to add. */
  readonly gather:
    | ((reply: Init<ServiceReply>, others: readonly ServiceReply[]) => Init<ServiceReply>)
    | undefined;
}

/** Returns a function that defines services whose handlers use no more than these parts of the master. */
export function definer<P extends keyof Core>() {
  return <S extends ServiceName>(name: S, definition: ServiceDefinition<S, P>): Service =>
    defineService(name, definition);
}

function defineService<S extends ServiceName, P extends keyof Core>(
  name: S,
  definition: ServiceDefinition<S, P>,
): Service {
  const { roles, subject, mayNameOthers = false, isSignOfLife = true } = definition;
  const { auditObject, target, gather, handle } = definition;
  const info: ServiceInfo = SERVICES[name];
  const given = (request: ServiceRequest) =>
    payloadOf(info, request) as NonNullable<ServicePayload<S>> | undefined;
  return {
    name,
    info,
    roles,
    isSignOfLife,
    actsForClient: subject !== undefined && !mayNameOthers,
    audited: auditObject !== undefined,
    subjectOf(request) {
      const payload = given(request);
      return (payload && subject?.(payload)) || undefined;
    },
    targetOf(request) {
      const payload = given(request);
      if (payload === undefined) return {};
      if (target !== undefined) return target(payload);
      const clientId = (!mayNameOthers && subject?.(payload)) || undefined;
      return clientId === undefined ? {} : { clientId };
    },
    auditObjectOf(core, request) {
      const payload = given(request);
      return payload === undefined ? '' : (auditObject?.(core, payload) ?? '');
    },
    async handle(core, request, call) {
      const reply = await handle(core, given(request) as ServicePayload<S>, call);
      return { [info.reply]: reply };
    },
    gather:
      gather &&
      ((reply, others) => {
        const payloads = others.map((other) => other[info.reply] as ServiceReplyOf<S> | undefined);
        const own = reply[info.reply] as Init<ServiceReplyOf<S>>;
        return {
          [info.reply]: gather(
            own,
            payloads.filter((one) => one !== undefined),
          ),
        };
      }),
  };
}

/** The reply of a service that has nothing to tell but that it succeeded. */
export function success(message: string): Init<Success> {
  return { title: 'Success', message };
}

function payloadOf({ request: member, alternativeRequest }: ServiceInfo, request: ServiceRequest) {
  if (alternativeRequest !== undefined) return request;
  return member === undefined ? undefined : request[member];
}
