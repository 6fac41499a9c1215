import { SessionState, type Session } from '@ubii/proto';
import type { ComputedRef } from 'vue';
import { useRouter } from 'vue-router';
import { useAttemptByKey } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { sessionLocation } from '../../locations/session-location.ts';
import { useSessionActions } from '../../sessions/actions/useSessionActions.ts';
import { isAlive, sessionState } from '../../sessions/state/session-state.ts';
import type { GalleryEntry } from './gallery.ts';
import { gallerySession, inputClient, sessionOfEntry, withInputsOf } from './gallery-session.ts';
import { usePageInputs } from './inputs/page-inputs.ts';
import type { PreviewKit } from './preview/preview-kit.ts';

/** The gallery's sessions on the master, and their actions. */
export interface GallerySessions {
  /** Returns the session of an example, if the master has one. */
  of(entry: GalleryEntry): Session | undefined;
  isRunning(entry: GalleryEntry): boolean;
  /** Ids of examples with a pending service request. */
  readonly busy: ComputedRef<ReadonlySet<string>>;
  /** Error of the last service request, by the id of the example. */
  readonly failures: ComputedRef<ReadonlyMap<string, string>>;
  /** Creates the session if the master has none, starts it, and opens its graph. */
  start(entry: GalleryEntry): Promise<void>;
  /** Creates the session if the master has none, and opens its graph. */
  open(entry: GalleryEntry): Promise<void>;
  stop(entry: GalleryEntry): Promise<void>;
  remove(entry: GalleryEntry): Promise<void>;
}

/** All clients share one session for each example: a second start opens the existing session. */
export function useGallerySessions(
  loadKit: () => Promise<Pick<PreviewKit, 'spec'>>,
): GallerySessions {
  const { client, clients, sessions } = useConnection();
  const router = useRouter();
  const actions = useSessionActions();
  const pageInputs = usePageInputs();
  const { problems: failures, busy, attempt } = useAttemptByKey();

  const of = (entry: GalleryEntry): Session | undefined =>
    sessionOfEntry(entry, sessions.list.value ?? []);

  async function change(entry: GalleryEntry, work: () => Promise<void>): Promise<void> {
    if (!busy.value.has(entry.id)) await attempt(entry.id, work);
  }

  /** Returns the existing session or a new one. This page provides its inputs, unless another page does. */
  async function ready(entry: GalleryEntry): Promise<Session> {
    const there = of(entry);
    if (there === undefined) {
      const spec = (await loadKit()).spec(entry);
      return actions.calls.create(gallerySession(entry, spec, client.id));
    }
    const giver = inputClient(entry, there);
    const isOurs = giver === undefined || giver === client.id;
    if (isOurs || (isAlive(there) && clients.find(giver) !== undefined)) return there;
    return actions.calls.update(there, { ioMappings: withInputsOf(entry, there, client.id) });
  }

  return {
    of,
    isRunning: (entry) => {
      const session = of(entry);
      return (
        session !== undefined &&
        (isAlive(session) || sessionState(session) === SessionState.SESSION_STARTING)
      );
    },
    busy,
    failures,
    start: (entry) =>
      change(entry, async () => {
        const session = await ready(entry);
        const giver = inputClient(entry, session);
        if (giver === undefined || giver === client.id) {
          pageInputs.give(
            session.id,
            entry.inputs.map(({ input }) => input),
          );
        }
        if (!isAlive(session)) await actions.calls.act(session, 'start');
        await router.push(sessionLocation(session.id));
      }),
    open: (entry) =>
      change(entry, async () => void (await router.push(sessionLocation((await ready(entry)).id)))),
    stop: (entry) =>
      change(entry, async () => {
        const session = of(entry);
        if (session) await actions.calls.act(session, 'stop');
      }),
    remove: async (entry) => {
      const session = of(entry);
      if (session) await actions.remove(session);
    },
  };
}
