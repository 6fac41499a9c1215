import { AuditLog } from '../audit/audit-log.ts';
import { DEFAULT_CHECKS } from '../checks/check-settings.ts';
import { OverloadChecks } from '../checks/overload-checks.ts';
import { ClientMeter } from '../clients/client-meter.ts';
import { Load } from '../counters/load.ts';
import { Samples } from '../counters/samples.ts';
import type { ClientArea } from './clients.ts';
import type { Foundation } from './foundation.ts';
import type { NodeArea } from './nodes.ts';
import type { SessionArea } from './sessions.ts';
import type { MasterPorts } from './settings.ts';

/** Measurements of a master, and its audit log. */
export type MonitoringArea = ReturnType<typeof createMonitoring>;

export type MonitoringAreaContext = Pick<MasterPorts, 'clock' | 'usage' | 'audit'> &
  Pick<Foundation, 'settings' | 'limits' | 'counters' | 'events' | 'onClose'> &
  Pick<ClientArea, 'clients'> &
  Pick<NodeArea, 'nodes'> &
  Pick<SessionArea, 'sessions'>;

export function createMonitoring(context: MonitoringAreaContext) {
  const { clock, usage, limits, counters, events, settings } = context;
  const { clients, nodes, sessions } = context;
  const clientMeter = new ClientMeter(clients);
  const checks = new OverloadChecks({
    clock,
    events,
    clients,
    settings: { ...DEFAULT_CHECKS, ...settings.checks },
    nodes,
    sessions: () => sessions.list(),
  });
  const load = new Load(clock, usage, (measured, seconds) => {
    clientMeter.measure(seconds);
    checks.look(measured);
  });
  const samples = new Samples(clock, load, counters);
  context.onClose.add(() => {
    samples.close();
    load.close();
  });
  return {
    load,
    clientMeter,
    checks,
    samples,
    /** Actions of admins and participants [EX-90]. */
    audit: new AuditLog({ clock, limits, audit: context.audit }),
  };
}
