import type { TerminalAccess } from '../../core/master/master.ts';

/**
 * Output of `--print-endpoints json`: one line of JSON for programs that start a master.
 *
 * @param terminal secrets for becoming admin and for joining
 */
export function formatEndpoints(localUrl: string, pid: number, terminal?: TerminalAccess): string {
  const { admin, join } = terminal ?? {};
  return JSON.stringify({
    url: localUrl,
    servicesJson: `${localUrl}/services/json`,
    servicesBinary: `${localUrl}/services/binary`,
    topicDataWs: `${localUrl.replace(/^http/, 'ws')}/topicdata`,
    pid,
    ...(admin && { adminToken: admin.token, adminCode: admin.code }),
    ...(join && { joinToken: join.token, joinCode: join.code }),
  });
}
