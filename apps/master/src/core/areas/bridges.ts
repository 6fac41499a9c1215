import { BridgeMappingsOfClients } from '../bridges/bridge-mappings.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { SessionArea } from './sessions.ts';
import type { MasterPorts } from './settings.ts';

/** Bridges to other systems, which are clients. */
export type BridgeArea = ReturnType<typeof createBridges>;

export type BridgeDependencies = Pick<MasterPorts, 'clock'> &
  Pick<Foundation, 'limits' | 'onClose'> &
  Pick<ClientArea, 'clients'> &
  Pick<SessionArea, 'reports'>;

export function createBridges(dependencies: BridgeDependencies) {
  const bridgeMappings = new BridgeMappingsOfClients(dependencies);
  dependencies.reports.onMessage.add((client, { bridgeAnswer }) => {
    if (bridgeAnswer !== undefined) bridgeMappings.handleAnswer(client, bridgeAnswer);
  });
  dependencies.onClose.add(() => bridgeMappings.close());
  return { bridgeMappings };
}
