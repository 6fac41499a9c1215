import type { ClientRole, JoinProblem } from '@ubii/client-web';
import type { Mark } from '@ubii/proto';
import type { NamedMark } from '../../marks/mark-words.ts';

/**
 * `asking`: the token is being checked; `code`: the user must enter a code; `ready`: the user can join; `joining`;
 * `unreachable`: no reply.
 */
export type JoinPhase = 'asking' | 'code' | 'ready' | 'joining' | 'unreachable';

/** Marks that the person can choose from. [EX-100] */
export interface OfferedMarks {
  /** One that no client here has; `undefined` with masters that give no marks. */
  readonly free: Mark | undefined;
  readonly taken: readonly NamedMark[];
}

/** Content of a valid token. */
export interface Invitation {
  readonly token: string;
  readonly role: ClientRole;
  /** Path of the page to open; empty when the token has none. */
  readonly target: string;
  /** True when this client has already joined with it. */
  readonly isJoined: boolean;
  readonly marks: OfferedMarks;
}

/** State of joining, from a token or code to the target page. */
export interface JoinState {
  readonly phase: JoinPhase;
  readonly problem?: JoinProblem | undefined;
  /** Error of joining, as reported by the master or the browser; empty when there is none. */
  readonly trouble: string;
  readonly invitation?: Invitation | undefined;
  readonly masterName: string;
  /** Number of checks started; replies to older ones are ignored. */
  readonly checks: number;
  /** True when the last reply was about this client, not about the token. */
  readonly isToClient: boolean;
  /** True when this client was connected before: it uses another code. */
  readonly wasConnected: boolean;
  readonly isLeaving: boolean;
}

/** State of page and connection at the time of an event. */
export interface Situation {
  /** Token or code in the URL; empty without one. */
  readonly token: string;
  /** A client that may have joined already opened the page to enter a code. */
  readonly wantsAnother: boolean;
  /** The page is open on the computer of the master. */
  readonly isThisMachine: boolean;
  readonly connection: 'connected' | 'reconnecting' | 'closed' | 'other';
  /** Reason why the master refused this client, if it did. */
  readonly refusal?: JoinProblem | undefined;
  /** Role of this client, once it has registered. */
  readonly role?: ClientRole | undefined;
}

/** Reply to a check of a token. */
export interface CheckReply {
  readonly masterName: string;
  readonly role: ClientRole | undefined;
  readonly problem: JoinProblem | undefined;
  readonly target: string;
  readonly isJoined: boolean;
  readonly marks: OfferedMarks;
}

export type JoinEvent =
  /** The page was opened, its URL changed, or the user or a timer repeats the check. */
  | { readonly type: 'check'; readonly token: string }
  | { readonly type: 'checked'; readonly check: Check; readonly reply: CheckReply }
  | { readonly type: 'unanswered'; readonly check: Check; readonly message: string }
  /** The user pressed Join. */
  | { readonly type: 'join' }
  /** A timer repeats joining. */
  | { readonly type: 'join-again' }
  /** The master has admitted this client. */
  | { readonly type: 'joined' }
  | { readonly type: 'refused'; readonly problem: JoinProblem | undefined }
  | { readonly type: 'failed'; readonly message: string }
  /** The connection changed. */
  | { readonly type: 'connection' }
  /** The user continues without a code. */
  | { readonly type: 'leave' };

/** Request to check a token. */
export interface Check {
  readonly number: number;
  readonly token: string;
  /** Sent as a client over the connection, instead of as a stranger. */
  readonly asClient: boolean;
}

export type JoinEffect =
  | { readonly type: 'check'; readonly check: Check }
  | { readonly type: 'later'; readonly afterMs: number; readonly event: JoinEvent }
  | { readonly type: 'forget-later' }
  | { readonly type: 'join'; readonly token: string }
  /** The client is registered, only its WebSocket is missing. */
  | { readonly type: 'reconnect' }
  | { readonly type: 'leave'; readonly becameAdmin: boolean };

/** Initial state. */
export const OPENED: JoinState = {
  phase: 'asking',
  trouble: '',
  masterName: '',
  checks: 0,
  isToClient: false,
  wasConnected: false,
  isLeaving: false,
};
