/** The line of `--print-endpoints json`. */
export interface MasterEndpoints {
  readonly url: string;
  readonly servicesJson: string;
  readonly servicesBinary: string;
  readonly topicDataWs: string;
  readonly pid: number;
  /** Token for joining; undefined for a master on loopback only. */
  readonly joinToken?: string;
  readonly joinCode?: string;
  /** Token for becoming admin on the master's computer. */
  readonly adminToken: string;
  readonly adminCode: string;
}
