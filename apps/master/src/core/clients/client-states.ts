import { ClientState } from '@ubii/proto';

/** Status of a client. [CL-10] */
export type ClientStatus = 'active' | 'inactive' | 'unavailable' | 'removed';

/** Events of a client. */
export type ClientEvent =
  /** It was active [CL-11]. */
  | 'sign'
  /** No activity for `silentAfterMs` [CL-13]. */
  | 'silent'
  /** Its socket closed [CL-13]. */
  | 'socket closed'
  /** No activity for `lostAfterMs` [CL-13]. */
  | 'lost'
  /** Unavailable for too long [CL-14]. */
  | 'expired'
  /** The client deregistered, or another client deregistered it [CL-16]. */
  | 'deregistered';

/** Every legal move; what is not here changes nothing. */
const MOVES: { readonly [S in ClientStatus]: { readonly [E in ClientEvent]?: ClientStatus } } = {
  active: {
    silent: 'inactive',
    'socket closed': 'inactive',
    lost: 'unavailable',
    deregistered: 'removed',
  },
  inactive: { sign: 'active', lost: 'unavailable', deregistered: 'removed' },
  unavailable: { sign: 'active', expired: 'removed', deregistered: 'removed' },
  removed: {},
};

export function nextStatus(status: ClientStatus, event: ClientEvent): ClientStatus {
  return MOVES[status][event] ?? status;
}

/** The state as the protocol knows it. */
export function wireState(status: ClientStatus): ClientState {
  if (status === 'active') return ClientState.ACTIVE;
  return status === 'inactive' ? ClientState.INACTIVE : ClientState.UNAVAILABLE;
}
