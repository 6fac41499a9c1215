import { createBirpc } from 'birpc';
import { packError, unpackError, type PackedError } from './packed-error.ts';

/** The functions of the other side: each replies with a promise. */
export type Calls<Functions> = {
  readonly [Name in keyof Functions]: Functions[Name] extends (...args: infer Args) => infer Result
    ? (...args: Args) => Promise<Awaited<Result>>
    : never;
};

/** The other side of a connection between a program and its worker. */
export interface Peer<Functions> {
  /** Functions start in the order of the calls. Nothing limits how long a reply takes. */
  readonly calls: Calls<Functions>;
  /** Rejects calls without a reply and all later ones with `error`. Messages that still come are ignored. */
  close(error: Error): void;
}

/** How messages travel. */
export interface Channel {
  /** @param transfer what the receiver takes over */
  post(message: object, transfer: object[]): void;
  receive(handle: (message: unknown) => void): void;
}

export interface PeerOptions {
  /** Converts what a function of this side throws. @default as it is */
  readonly asError?: (thrown: unknown) => unknown;
  /** Gets what a function of this side throws, besides the caller. */
  readonly onError?: (thrown: unknown) => void;
}

/** What this module knows of the messages of birpc: arguments of a call, result or error of a reply. */
interface Message {
  readonly a?: readonly unknown[];
  readonly r?: unknown;
  readonly e?: unknown;
}

type AnyFunctions = Record<string, (...args: unknown[]) => unknown>;

const transferred = new WeakMap<object, readonly object[]>();

/**
 * Marks an argument or a result: its receiver takes over what is in `list`, and nothing of it is copied.
 *
 * @returns `value`
 */
export function transfer<T extends object>(value: T, list: readonly object[] = [value]): T {
  transferred.set(value, list);
  return value;
}

const transferOf = ({ a = [], r }: Message): object[] =>
  [...a, r].flatMap((value) =>
    typeof value === 'object' && value !== null ? (transferred.get(value) ?? []) : [],
  );

/** Connects this side, with the functions that the other one may call. */
export function connectPeer<Functions>(
  functions: object,
  { post, receive }: Channel,
  { asError = (thrown) => thrown, onError }: PeerOptions = {},
): Peer<Functions> {
  let closedBy: Error | undefined;
  const rpc = createBirpc<AnyFunctions, object, false>(functions, {
    proxify: false,
    bind: 'functions',
    timeout: -1,
    post: (message: Message) => post(message, transferOf(message)),
    // Returns nothing: calls would wait for it.
    on(handle) {
      receive((message) => {
        if (closedBy === undefined) handle(message);
      });
    },
    serialize: (message: Message) =>
      message.e === undefined ? message : { ...message, e: packError(asError(message.e)) },
    deserialize: (message: Message) =>
      message.e === undefined ? message : { ...message, e: unpackError(message.e as PackedError) },
    onFunctionError: (error) => void onError?.(error),
    // A result that cannot be copied is an error for the caller; a call that cannot be sent rejects.
    onGeneralError: (_error, ofFunction) => ofFunction !== undefined,
  });
  const call = (name: string, args: unknown[]): Promise<unknown> =>
    closedBy === undefined ? rpc.$call(name, ...args) : Promise.reject(closedBy);
  const calls = new Proxy<object>(
    {},
    {
      get: (_target, name) =>
        // A promise that resolved with it would look for `then`.
        typeof name === 'string' && name !== 'then'
          ? (...args: unknown[]) => call(name, args)
          : undefined,
    },
  );
  return {
    calls: calls as Calls<Functions>,
    close(error) {
      closedBy ??= error;
      void Promise.all(rpc.$rejectPendingCalls(({ reject }) => reject(error)));
    },
  };
}
