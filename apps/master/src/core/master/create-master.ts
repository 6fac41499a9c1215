import { StatusEventKind, type Recording, type ServiceRequest } from '@ubii/proto';
import { fileMakerOf, requireFilesOf } from '../access/file-maker.ts';
import { openTerminal } from '../access/open-terminal.ts';
import type { Role } from '../access/roles.ts';
import { createCore } from '../areas/core.ts';
import type { MasterPorts, MasterSettings } from '../areas/settings.ts';
import { readMetrics } from '../monitoring/metrics.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import type { ClientConnection } from '../ports/client-connection.ts';
import type { ClientClaim, ConnectionPeer } from '../ports/connection-facts.ts';
import type { ConnectionHandle } from '../ports/connection-handle.ts';
import { uploadSenderOf, type NodeUpload, type Upload } from '../recordings/recording-uploads.ts';
import { openAudit, writeResult } from '../services/audit.ts';
import { watchGrants } from '../services/grant-work.ts';
import { IncomingRequest } from '../services/incoming-request.ts';
import { answerRequest, refuse } from '../services/router.ts';
import type { RestoreReport, SessionsAtStop } from '../sessions/restored-sessions.ts';
import type { Master, MasterMetrics, ServiceAnswer, TerminalAccess } from './master.ts';

/** Creates a master. Until its first call, it only measures time. */
export function createMaster(ports: MasterPorts, settings: MasterSettings): Master {
  const core = createCore(ports, settings, (request, facts) => answerRequest(core, request, facts));
  core.events.add(StatusEventKind.MASTER_STARTED, 'The master started');
  if (core.masters === undefined) {
    core.sessions.restored.restore((grantId) => core.access.grants.isValid(grantId)); // [SE-24]
  }
  core.onClose.add(watchGrants(core));
  return {
    id: core.id,
    admitConnection(peer, cut) {
      return core.connections.admit(peer, cut);
    },
    openRequest(caller: CallerFacts, connection: object): IncomingRequest {
      return new IncomingRequest(core, caller, connection);
    },
    handleServiceRequest(
      request: ServiceRequest,
      caller: CallerFacts,
      incoming?: IncomingRequest,
    ): Promise<ServiceAnswer> {
      return answerRequest(core, request, caller, incoming?.caller);
    },
    refuseServiceRequest(cause: unknown): ServiceAnswer {
      return refuse(core, cause);
    },
    provesLocalClient({ clientId = '', token = '' }: ClientClaim): boolean {
      return core.access.provesLocalClient(clientId, token);
    },
    refuseConnection(claim: ClientClaim, caller: CallerFacts): string | undefined {
      return core.sockets.refuse(claim, caller);
    },
    maxMessageBytes({ clientId = '' }: ClientClaim): number {
      const { frameBytes, frameBytesOfPlayer } = core.limits;
      const known = core.clients.get(clientId);
      // No client, no message: the connection will be closed.
      return known?.publishLimits.frameBytes.value ?? Math.min(frameBytes, frameBytesOfPlayer);
    },
    openConnection(
      claim: ClientClaim,
      connection: ClientConnection,
      caller: CallerFacts,
      peer?: ConnectionPeer,
    ): ConnectionHandle | undefined {
      return core.sockets.open(claim, connection, caller, peer);
    },
    roleOf(caller: CallerFacts): Role {
      return core.access.identify(caller).role;
    },
    recognizes(caller: CallerFacts): boolean {
      const { kind } = core.access.identify(caller);
      return kind === 'client' || kind === 'joining';
    },
    openTerminal(isReachable: boolean): Promise<TerminalAccess> {
      return openTerminal(core, isReachable);
    },
    otherMasterAddresses(): readonly string[] {
      return core.masters?.clusterAddresses.list() ?? [];
    },
    metrics(): MasterMetrics {
      return readMetrics(core);
    },
    async requireRecording(id: string, facts: CallerFacts): Promise<Recording> {
      const caller = core.access.identify(facts);
      requireFilesOf(await core.recordings.makerOf(id), caller, 'recordings');
      return (await core.recordings.get(id)).recording;
    },
    uploadRecording(upload: Upload, name: string, facts: CallerFacts): Promise<Recording> {
      const caller = core.access.identify(facts);
      // What people upload becomes no part of a study, unless an admin brings it back. [RC-41]
      const keepsStudy = caller.role === 'admin';
      const wish = { name, notes: '', author: '', makerId: fileMakerOf(caller), keepsStudy };
      const write = openAudit(core, caller, { service: 'POST /recordings', object: name });
      const sender = uploadSenderOf(caller, facts.place);
      return writeResult(write, () => core.recordings.upload(upload, wish, sender));
    },
    uploadNodeRecording(upload: NodeUpload, facts: CallerFacts): Promise<Recording> {
      const caller = core.access.identify(facts);
      const object = upload.recordingId;
      const write = openAudit(core, caller, { service: 'POST /recordings', object });
      return writeResult(write, () => core.recordings.uploadOfNode(upload, caller));
    },
    sessionsAtStop(): SessionsAtStop {
      return core.sessions.atStop();
    },
    sessionsRestored(): Promise<RestoreReport> {
      return core.sessions.restored.report();
    },
    async close(): Promise<void> {
      core.onClose.emit();
      await ports.replayFiles.close();
      await core.recordings.close();
      await core.localNode.close();
      await ports.sandboxes.close();
      ports.cluster?.owners.close();
      await ports.cluster?.bus.close();
    },
  };
}
