import type { ClientRole, JoinProblem } from '@ubii/client-web';

/**
 * `asking`: checks the token · `code`: the user has to type a code · `ready`: one tap away ·
 * `joining` · `unreachable`: no answer
 */
export type JoinPhase = 'asking' | 'code' | 'ready' | 'joining' | 'unreachable';

/** What a valid token gives. */
export interface Invitation {
  readonly token: string;
  readonly role: ClientRole;
  /** Path of the page that opens; empty when the token names none. */
  readonly target: string;
  /** This client has joined with it: there is nothing to be asked. */
  readonly isJoined: boolean;
}

/** How far a device has come from a token or code to the page it came for. */
export interface JoinState {
  readonly phase: JoinPhase;
  readonly problem?: JoinProblem | undefined;
  /** Error of joining, as reported by the master or the browser; empty when there is none. */
  readonly trouble: string;
  readonly invitation?: Invitation | undefined;
  readonly masterName: string;
  /** Number of checks begun: only the newest one counts. */
  readonly checks: number;
  /** True when the last reply was about this client, not about the token. */
  readonly isToClient: boolean;
  /** This client was connected before it began to join: it uses another code. */
  readonly wasConnected: boolean;
  readonly isLeaving: boolean;
}

/** What the page and the connection are like when something happens. */
export interface Situation {
  /** Token or code in the address; empty without one. */
  readonly token: string;
  /** A client that may have joined already opened the page to enter a code. */
  readonly wantsAnother: boolean;
  /** The page is open on the computer of the master. */
  readonly isThisMachine: boolean;
  readonly connection: 'connected' | 'reconnecting' | 'closed' | 'other';
  /** Why the master refused this client, when it did. */
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
}

export type JoinEvent =
  /** The page opened, its address changed, the user or a timer asks again. */
  | { readonly type: 'check'; readonly token: string }
  | { readonly type: 'checked'; readonly check: Check; readonly reply: CheckReply }
  | { readonly type: 'unanswered'; readonly check: Check; readonly message: string }
  /** The user taps Join. */
  | { readonly type: 'join' }
  /** A timer does it again. */
  | { readonly type: 'join-again' }
  /** The master has admitted this client. */
  | { readonly type: 'joined' }
  | { readonly type: 'refused'; readonly problem: JoinProblem | undefined }
  | { readonly type: 'failed'; readonly message: string }
  /** The connection changed. */
  | { readonly type: 'connection' }
  /** The user continues without a code. */
  | { readonly type: 'leave' };

/** A question to the master about a token. */
export interface Check {
  readonly number: number;
  readonly token: string;
  /** Asked as a client over the connection, not as a stranger. */
  readonly asClient: boolean;
}

export type JoinEffect =
  | { readonly type: 'check'; readonly check: Check }
  | { readonly type: 'later'; readonly afterMs: number; readonly event: JoinEvent }
  | { readonly type: 'forget-later' }
  | { readonly type: 'join'; readonly token: string }
  /** The client has registered, only its live channel is missing. */
  | { readonly type: 'reconnect' }
  | { readonly type: 'leave'; readonly becameAdmin: boolean };

/** Before anything is known. */
export const OPENED: JoinState = {
  phase: 'asking',
  trouble: '',
  masterName: '',
  checks: 0,
  isToClient: false,
  wasConnected: false,
  isLeaving: false,
};
