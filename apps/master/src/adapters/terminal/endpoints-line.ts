/**
 * What `--print-endpoints json` prints: one line of JSON for programs that start a master.
 *
 * @param join what others join with; undefined when only this machine reaches the master
 */
export function formatEndpoints(
  localUrl: string,
  pid: number,
  join?: { readonly token: string; readonly code: string },
): string {
  return JSON.stringify({
    url: localUrl,
    servicesJson: `${localUrl}/services/json`,
    servicesBinary: `${localUrl}/services/binary`,
    topicDataWs: `${localUrl.replace(/^http/, 'ws')}/topicdata`,
    pid,
    ...(join && { joinToken: join.token, joinCode: join.code }),
  });
}
