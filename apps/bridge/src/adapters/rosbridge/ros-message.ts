/** A message of ROS, as JSON has it. */
export type RosMessage = Readonly<Record<string, unknown>>;
