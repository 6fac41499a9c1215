import { TextCache } from '@ubii/proto/wire';
import { Access } from '../access/access.ts';
import { Grants } from '../access/grants.ts';
import { GuessLimit } from '../access/guess-limit.ts';
import { FrameSlices } from '../clients/frame-slices.ts';
import { SocketAdmission } from '../clients/socket-admission.ts';
import { BodyAccounts } from '../connections/body-accounts.ts';
import { Connections } from '../connections/connections.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { SessionArea } from './sessions.ts';
import type { MasterPorts } from './settings.ts';
import type { TopicArea } from './topics.ts';

/** Admission of callers, connections and sockets. */
export type AccessArea = ReturnType<typeof createAccess>;

export type AccessAreaContext = Pick<
  MasterPorts,
  'clock' | 'ids' | 'log' | 'tokens' | 'accessSecrets' | 'grants' | 'cluster'
> &
  Pick<Foundation, 'settings' | 'limits' | 'limitWatch' | 'counters' | 'onClose'> &
  Pick<
    TopicArea,
    'accounts' | 'topics' | 'kept' | 'tap' | 'replayed' | 'subscriptions' | 'endOfTurn'
  > &
  Pick<ClientArea, 'clients' | 'dismissals'> &
  Pick<SessionArea, 'reports'>;

export function createAccess(context: AccessAreaContext) {
  const { clock, ids, log, tokens, accessSecrets: secrets, limits, limitWatch } = context;
  const { clients, reports } = context;
  const access = new Access({
    clock,
    secrets,
    tokens,
    grants: new Grants({
      clock,
      ids,
      log,
      secrets,
      store: context.grants,
      limits: limitWatch,
      isShared: context.cluster !== undefined,
      installation: context.settings.installation ?? '',
    }),
    guesses: new GuessLimit(clock, limitWatch),
    accessOf: (clientId) => clients.get(clientId)?.access,
  });
  const connections = new Connections(clock, limitWatch);
  context.onClose.add(() => connections.close());
  return {
    access,
    /** Connections to all ports. */
    connections,
    /** Service requests in flight. */
    bodies: new BodyAccounts(limits, limitWatch),
    sockets: new SocketAdmission({
      ...context,
      access,
      topicTexts: new TextCache(),
      slices: new FrameSlices(clock),
      onNodeMessage: (client, bytes) => reports.handleMessage(client, bytes),
    }),
  };
}
