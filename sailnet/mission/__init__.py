"""What a mission file says: sail, transfer, flight, recipes, disturbances."""
