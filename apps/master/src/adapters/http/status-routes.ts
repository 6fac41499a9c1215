import type { FastifyInstance, FastifyRequest } from 'fastify';

import type { Master, MasterMetrics, Role } from '../../core/master/master.ts';
import type { CallerReader } from '../access/caller-reader.ts';

export interface StatusRoutesContext {
  readonly master: Pick<Master, 'id' | 'metrics' | 'roleOf'>;
  readonly callers: Pick<CallerReader, 'read'>;
  readonly name: string;
  readonly version: string;
  /** Metrics of the edge itself. */
  readonly edgeMetrics: () => MasterMetrics;
}

/** `/health` for health checks, `/metrics` for Prometheus. */
export function addStatus(app: FastifyInstance, context: StatusRoutesContext): void {
  const { master, callers, name, version, edgeMetrics } = context;
  const roleOf = (request: FastifyRequest): Role => master.roleOf(callers.read(request.raw));
  app.get('/health', (request, reply) => {
    const details = {
      id: master.id,
      name,
      version,
      uptimeSeconds: Math.round(process.uptime()),
    };
    // A stranger may only learn that the master runs. [AC-5]
    const isStranger = roleOf(request) === 'none';
    return reply
      .header('cache-control', 'no-store')
      .send({ status: 'ok', ...(isStranger ? {} : details) });
  });
  app.get('/metrics', async (_request, reply) => {
    // Few masters are watched by Prometheus: its library is loaded for those that are.
    const { formatMetrics } = await import('./prometheus.ts');
    const { contentType, text } = await formatMetrics([...master.metrics(), ...edgeMetrics()]);
    return reply.header('cache-control', 'no-store').type(contentType).send(text);
  });
}
