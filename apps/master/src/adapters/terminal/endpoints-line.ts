/** What `--print-endpoints json` prints: one line of JSON for programs that start a master. */
export function formatEndpoints(localUrl: string, pid: number): string {
  return JSON.stringify({
    url: localUrl,
    servicesJson: `${localUrl}/services/json`,
    servicesBinary: `${localUrl}/services/binary`,
    topicDataWs: `${localUrl.replace(/^http/, 'ws')}/topicdata`,
    pid,
  });
}
