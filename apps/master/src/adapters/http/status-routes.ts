import type { FastifyInstance } from 'fastify';

import type { Master, MasterMetrics } from '../../core/master.ts';

export interface StatusOptions {
  readonly master: Pick<Master, 'id' | 'metrics'>;
  readonly name: string;
  readonly version: string;
  /** Metrics of the edge itself. */
  readonly edgeMetrics: () => MasterMetrics;
}

/** `/health` for whoever watches that the master runs, `/metrics` for Prometheus. */
export function addStatus(app: FastifyInstance, options: StatusOptions): void {
  const { master, name, version, edgeMetrics } = options;
  app.get('/health', (_request, reply) =>
    reply.header('cache-control', 'no-store').send({
      status: 'ok',
      id: master.id,
      name,
      version,
      uptimeSeconds: Math.round(process.uptime()),
    }),
  );
  app.get('/metrics', async (_request, reply) => {
    // Few masters are watched by Prometheus: its library is loaded for those that are.
    const { formatMetrics } = await import('./prometheus.ts');
    const { contentType, text } = await formatMetrics([...master.metrics(), ...edgeMetrics()]);
    return reply.header('cache-control', 'no-store').type(contentType).send(text);
  });
}
