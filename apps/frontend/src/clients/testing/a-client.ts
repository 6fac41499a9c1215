import {
  ClientActivityAddressKind,
  type Client,
  type ClientActivity,
  type StatusProblem,
} from '@ubii/proto';
import { viewClient, type ClientView } from '../model/client-view.ts';

const CLIENT = {
  devices: [],
  tags: [],
  description: '',
  processingModules: [],
  isDedicatedProcessingNode: false,
  state: 0,
  latency: 0,
};

const ACTIVITY = {
  addressKind: ClientActivityAddressKind.LOOPBACK,
  addressGroup: '',
  connected: true,
  userAgent: '',
  library: '',
  recordsInPerSecond: 0,
  recordsOutPerSecond: 0,
  bytesInPerSecond: 0,
  bytesOutPerSecond: 0,
  queuedRecords: 0,
  queuedBytes: 0,
  dropped: 0,
  refused: 0,
  workShare: 0,
  watchesEverything: false,
  subscriptions: [],
};

/** Client for tests; members are empty unless given. */
export function aClient(id: string, changes: Partial<Client> = {}): Client {
  return { ...CLIENT, id, name: id, ...changes } as unknown as Client;
}

/** Client statistics for tests; members are zero unless given. */
export function anActivity(changes: Partial<ClientActivity>): ClientActivity {
  return { ...ACTIVITY, ...changes } as unknown as ClientActivity;
}

/** Client with statistics, for tests. */
export function aView(
  id: string,
  activity: Partial<ClientActivity> = {},
  client: Partial<Client> = {},
  problems: readonly Partial<StatusProblem>[] = [],
): ClientView {
  return viewClient(
    aClient(id, client),
    anActivity({ clientId: id, ...activity }),
    problems.map(
      (problem) => ({ clientId: id, text: '', remedy: '', ...problem }) as StatusProblem,
    ),
    'me',
  );
}
